#pragma once
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "faster/data/stimulus.hpp"
#include "modules/core/core_context.hpp"

namespace faster {

/// Keeps the maps that the first samples of a run leave.
class KeptMaps : public SampleProbe {
  public:
    /// Of samples below `count`.
    explicit KeptMaps(std::size_t count = std::numeric_limits<std::size_t>::max()) : count_(count) {}

    void edge_maps_done(std::size_t sample, EdgeMapView const& maps) override;
    void depth_buffer_done(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) override;

    /// Of a sample; null if the run did not get there.
    SampleMaps const* of(std::size_t sample) const;
    /// By sample.
    std::map<std::size_t, SampleMaps> const& all() const { return maps_; }

  private:
    std::size_t count_;
    std::map<std::size_t, SampleMaps> maps_;
};

}  // namespace faster
