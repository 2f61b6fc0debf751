#pragma once
#include <cstddef>
#include <vector>

#include "common/stimulus.hpp"
#include "modules/core_context.hpp"
#include "reference/quality/quality_sums.hpp"
#include "reference/quality/sample_judge.hpp"

namespace faster {

/// Judges the edge maps of the first samples of a run by their silhouettes.
class EdgeMapJudge : public SampleProbe {
  public:
    /// `side`: which contour to judge by. `count`: number of samples. The stimulus is held by reference.
    EdgeMapJudge(Stimulus const& stimulus, quality::ContourSide side, std::size_t count)
        : judge_(stimulus, side), count_(count) {}

    void edge_maps_done(std::size_t sample, EdgeMapView const& maps) override;
    void depth_buffer_done(std::size_t, std::vector<std::uint16_t> const&) override {}

    quality::QualitySums const& sums() const { return sums_; }

  private:
    quality::SampleJudge judge_;
    std::size_t count_;
    quality::QualitySums sums_;
};

}  // namespace faster
