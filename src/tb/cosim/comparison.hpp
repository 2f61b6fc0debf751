#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "kernel/machine/core_share.hpp"
#include "kernel/recording/recorded_core.hpp"
#include "modules/core_context.hpp"
#include "tb/cosim/recent_tokens.hpp"
#include "tb/cosim/twin_core.hpp"

namespace faster::rtl {

/// Where model and twin differ first.
struct Difference {
    Cycles cycle = 0;
    std::string what;                  ///< FIFO or memory, and both values; one line
    std::vector<std::string> history;  ///< accesses of both in the last cycles with any, a line each
    // For waveforms: some cycles before it, and some after it, in which model and twin went on.
    Cycles from = 0;
    Cycles to = 0;
    RecentTokens model;
    RecentTokens twin;
};

/// What a comparison went through.
struct Compared {
    Cycles cycles = 0;
    std::uint64_t writes = 0;
    std::uint64_t reads = 0;
    std::uint64_t maps = 0;
    double twin_seconds = 0;  ///< of the host, for the twin alone
    std::optional<Difference> difference;
};

/// Keeps the maps that a run of the model leaves, for compare().
class KeptMaps final : public SampleProbe {
  public:
    void edge_maps_done(std::size_t sample, EdgeMapView const& maps) override;
    void depth_buffer_done(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) override;

    /// Of a sample; null if the run did not get there.
    SampleMaps const* of(std::size_t sample) const;

  private:
    std::map<std::size_t, SampleMaps> maps_;
};

/// Goes with the twin through everything that was recorded of a core of the model, from cycle 0 on: every write with
/// its token, every read, in its cycle, and every sample's maps; up to the first difference. Behind the last access the
/// twin has to keep still.
Compared compare(recording::RecordedCore const& model, KeptMaps const& maps, TwinSettings const& settings,
                 Stimulus const& stimulus, CoreShare share);

}  // namespace faster::rtl
