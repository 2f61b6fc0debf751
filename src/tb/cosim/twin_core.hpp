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
    virtual ~TwinCore() = default;

    /// Accesses of this cycle, a bit per FIFO of twin_fifos.
    virtual std::uint32_t writes() const = 0;
    virtual std::uint32_t reads() const = 0;
    /// A field of the token that is written to a FIFO in this cycle, in the order of its TokenFields.
    virtual std::int64_t field(std::size_t fifo, std::size_t number) const = 0;

    /// A sample's maps, or its depth buffer, are complete in this cycle.
    virtual bool maps_are_built() const = 0;
    virtual bool depth_buffer_is_drawn() const = 0;
    /// What they hold, row by row.
    virtual std::vector<std::uint8_t> edge_map() = 0;
    virtual std::vector<std::uint8_t> object_map() = 0;
    virtual std::vector<std::uint16_t> depth_buffer() = 0;

    /// On to the next cycle.
    virtual void step() = 0;
};

/// In its first cycle: rtl/cosimulated_core.sv or, with settings.lanes, rtl/lanes. Of `samples` samples from `first`
/// on; the stimulus must outlive it. Errors: std::logic_error without has_twin().
std::unique_ptr<TwinCore> make_twin(TwinSettings const& settings, Stimulus const& stimulus, std::size_t first,
                                    std::size_t samples);

}  // namespace faster::rtl
