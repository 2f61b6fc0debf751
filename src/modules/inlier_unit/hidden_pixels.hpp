#pragma once
#include <cstddef>
#include <cstdint>

#include "faster/data/sample_counters.hpp"

namespace faster::datapath {

/// Tells drawn pixels in front of which something was measured from all other drawn ones: counts the former, and has
/// the box of the latter (docs/function.md#hidden-pixels). Depths are codes with `depth_fraction` fractional bits.
class HiddenSweep {
  public:
    HiddenSweep(int window, int depth_fraction);

    /// Goes over pixels [first, first + count) of the window, adding to `counters`. Pixels come in row-major order,
    /// those of a box too; `observed_depth` holds the tokens of these pixels, `depth_buffer` the whole window.
    void sweep(std::size_t first, std::size_t count, std::uint16_t const* depth_buffer,
               std::uint16_t const* observed_depth, SampleCounters& counters) const;

  private:
    void sweep_row(std::size_t row, std::size_t first_col, std::size_t end_col, std::uint16_t const* drawn,
                   std::uint16_t const* observed, SampleCounters& counters) const;

    std::size_t side_;
    unsigned near_limit_;  ///< 2.0 m: depths below it count as drawn
    unsigned tolerance_;   ///< 1/128 m, in codes
};

}  // namespace faster::datapath
