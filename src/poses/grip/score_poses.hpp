#pragma once
#include <vector>

#include "dataflow/base/counted_progress.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/grip/inlier_ratio.hpp"

namespace faster::grip {

/// What the baseline leaves to choose.
struct Settings {
    int neighbourhood = 5;           ///< side of eq. 2.2's [px], odd
    double threshold = 0.01;         ///< of eq. 2.2, of rendered and observed points alike
    double inlier_distance = 0.008;  ///< of eq. 2.1 [m]; the thesis's value for depths (A.3)
    double background = 3.998;       ///< depth of what the rendered object stands before [m]
};

/// Scores poses by the method of the thesis's baseline GRIP (chapter 2): renders the object as a point cloud, finds its
/// features, and compares them with those of the observation. Over the whole image, without windows. May be used by
/// several threads at once.
class PoseScorer {
  public:
    /// `stimulus`: a posed one, held by reference; its mesh, camera and observation must not change.
    PoseScorer(Stimulus const& stimulus, Settings const& settings);

    /// `box`: what PoseScore::in_box is counted in.
    PoseScore score(Pose const& pose, PixelArea const& box = {}) const;

  private:
    Stimulus const& stimulus_;
    Settings settings_;
    FeatureCloud observed_;
};

/// Every pose of a posed stimulus, on `jobs` threads, at least one.
std::vector<PoseScore> score_poses(Stimulus const& stimulus, Settings const& settings, unsigned jobs,
                                   TellProgress const& progress = {});

}  // namespace faster::grip
