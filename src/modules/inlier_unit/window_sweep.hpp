#pragma once
#include <cstdint>
#include <vector>

#include "faster/data/tokens.hpp"

namespace faster::datapath {

/// Whose depth a contour pixel is compared with: that of a drawn neighbour, as it lies beside the object (thesis A.3),
/// or its own (7.2).
enum class ContourDepth { neighbour, own };

/// Thesis A.3's last loop: compares the drawn window with the observed one, pixel by pixel in row-major order, and
/// counts (docs/function.md#inlierunit). Depths are codes with `depth_fraction` fractional bits.
class WindowSweep {
  public:
    WindowSweep(int window, int depth_fraction, ContourDepth contour_depth = ContourDepth::neighbour);

    /// Goes over pixels [first, first + count) of the window, adding to `counters`. `edge`, `observed_depth` and
    /// `observed_edge` hold the tokens of these pixels; `depth_buffer` the whole window.
    void sweep(std::size_t first, std::size_t count, std::uint16_t const* depth_buffer, std::uint8_t const* edge,
               std::uint16_t const* observed_depth, std::uint8_t const* observed_edge, SampleCounters& counters) const;

  private:
    bool agrees(unsigned depth, unsigned observed) const;
    void sweep_row(std::size_t count, std::uint16_t const* depth, std::uint8_t const* edge,
                   std::uint16_t const* observed, std::uint8_t const* observed_edge, SampleCounters& counters) const;
    void count_edge(std::uint16_t const* depth, unsigned observed, bool observed_edge, SampleCounters& counters) const;

    unsigned depth_of_edge(std::uint16_t const* depth) const;

    int window_;
    ContourDepth contour_depth_;
    unsigned near_limit_;   ///< 2.0 m: depths below it count as drawn
    unsigned valid_limit_;  ///< 3.0 m
    unsigned tolerance_;    ///< 1/128 m, in codes
};

}  // namespace faster::datapath
