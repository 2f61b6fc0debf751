#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "faster/data/stimulus.hpp"
#include "tb/cosim/twin_settings.hpp"

namespace faster::rtl {

/// Whether this program was built with Verilator.
bool has_twin();

/// A raster core at register-transfer level (rtl/), verilated: goes from cycle to cycle. Its surroundings are here:
/// headers, vertices and the observation come from the stimulus as soon as it asks.
class TwinCore {
  public:
    /// Of `samples` samples from `first` on; the stimulus must outlive it. Errors: std::logic_error without has_twin().
    TwinCore(TwinSettings const& settings, Stimulus const& stimulus, std::size_t first, std::size_t samples);
    ~TwinCore();

    /// Accesses of this cycle, a bit per FIFO of twin_fifos.
    std::uint32_t writes() const;
    std::uint32_t reads() const;
    /// A field of the token that is written to a FIFO in this cycle, in the order of its TokenFields.
    std::int64_t field(std::size_t fifo, std::size_t number) const;

    /// A sample's maps, or its depth buffer, are complete in this cycle.
    bool maps_are_built() const;
    bool depth_buffer_is_drawn() const;
    /// What they hold, row by row.
    std::vector<std::uint8_t> edge_map() const;
    std::vector<std::uint8_t> object_map() const;
    std::vector<std::uint16_t> depth_buffer() const;

    /// On to the next cycle.
    void step();

    struct Parts;  ///< of one of two models, rtl/cosimulated_core.sv or, with settings.lanes, rtl/lanes

  private:
    std::unique_ptr<Parts> parts_;
};

}  // namespace faster::rtl
