#pragma once
#include <cstddef>
#include <vector>

#include "common/stimulus.hpp"
#include "modules/core_context.hpp"
#include "quality/quality_sums.hpp"
#include "quality/sample_judge.hpp"

namespace faster {

/// Judges the edge maps of the first samples of a run by their silhouettes.
class EdgeMapJudge : public SampleProbe {
  public:
    /// `count`: number of samples. The stimulus is held by reference.
    EdgeMapJudge(Stimulus const& stimulus, EdgeMapAlgorithm algorithm, std::size_t count)
        : judge_(stimulus, quality::side_of(algorithm)), count_(count) {}

    void edge_maps_done(std::size_t sample, datapath::EdgeMapPolicy const& maps) override;
    void depth_buffer_done(std::size_t, std::vector<std::uint16_t> const&) override {}

    quality::QualitySums const& sums() const { return sums_; }

  private:
    quality::SampleJudge judge_;
    std::size_t count_;
    quality::QualitySums sums_;
};

}  // namespace faster
