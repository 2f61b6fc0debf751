#pragma once
#include <cstdint>

namespace faster {

/// Who scores the samples.
enum class EstimatorBackend {
    accelerator,  ///< the configured design
    grip,         ///< the thesis's CPU and GPU baseline, in software
};

/// How samples are drawn in proportion to their weights. All keep the expected number of copies.
enum class Resampling {
    systematic,   ///< one number places a comb of equal steps
    stratified,   ///< a number in each of the equal steps
    multinomial,  ///< each draw on its own
};

/// What an estimate is when the loop is over.
enum class EstimateKind {
    best,  ///< the pose of the largest weight
    mean,  ///< the weighted mean of the poses close to it
};

/// What becomes of the estimate when the loop is over.
enum class Refinement {
    none,
    icp,  ///< the host moves it so that the surface lies in the readings
};

/// How I_b of thesis eq. 2.4 is had, whoever scores: the inliers in the box of the first stage, as a share.
enum class InBoxTerm {
    overlap,     ///< I_r times the overlap of the sample's box and the detection's
    all_points,  ///< eq. 2.3: of all rendered points
    box_points,  ///< of the rendered points in the box
    none,        ///< left out; the other coefficients are scaled to add up to 1
};

/// Coefficients of thesis eq. 2.4, which add up to 1.
struct WeightCoefficients {
    double box = 0;     ///< a_box, of the box's confidence
    double in_box = 0;  ///< a_b, of the inlier ratio of what lies in the box
    double raw = 0;     ///< a_r, of all inliers
    double edge = 0;    ///< a_e, of the edges' inliers
    double planar = 0;  ///< a_p, of the planar points' inliers

    /// Those that are left, which add up to 1.
    WeightCoefficients without_in_box() const {
        double const rest = 1 - in_box;
        return {box / rest, 0, raw / rest, edge / rest, planar / rest};
    }
};

/// Noise that is added after resampling: sigma of iteration k = max(sigma_min, sigma * decay^k).
struct DiffusionConfig {
    double translation_sigma_m = 0.02;
    double translation_sigma_min_m = 0.001;
    double rotation_sigma_deg = 25;
    double rotation_sigma_min_deg = 1;
    double decay = 0.9;
};

/// What the first stage of the thesis found: where the object is in the image, with the confidence w_box. Pixels [left,
/// left + width) x [top, top + height).
struct DetectionConfig {
    double left = 0;
    double top = 0;
    double width = 0;  ///< 0: the box around the object under the configured pose
    double height = 0;
    double confidence = 1;
};

/// The second stage of the thesis (2.1, 4.2.1): keys `estimator.*`.
struct EstimatorConfig {
    EstimatorBackend backend = EstimatorBackend::accelerator;
    std::uint64_t iterations = 50;  ///< thesis 4.2.1
    std::uint64_t restarts = 1;     ///< runs that know nothing of each other; the heaviest estimate is kept
    Refinement refine = Refinement::none;
    double stop_weight = 1;
    double least_weight = 0.55;  ///< of training scenes, nine in ten estimates of so much were below 2 cm
    EstimateKind estimate = EstimateKind::best;
    std::uint64_t seed = 3;
    WeightCoefficients accelerator_weights{0.1, 0.7, 0.1, 0.1, 0};
    WeightCoefficients grip_weights{0.1, 0.7, 0.1, 0.05, 0.05};
    InBoxTerm in_box = InBoxTerm::overlap;
    double hidden = 0.7;      ///< share of the hidden pixels that does not count as drawn, where they are counted
    bool visible_box = true;  ///< where hidden pixels are counted: the sample's box is that of the others
    std::uint64_t least_drawn_px = 100;
    double grip_inlier_distance_m = 0.008;
    Resampling resampling = Resampling::systematic;
    double sharpness = 5;
    DiffusionConfig diffusion;
    double cluster_translation_m = 0.01;
    double cluster_rotation_deg = 10;
    DetectionConfig box;

    /// Of all runs, at most.
    std::uint64_t all_iterations() const { return restarts * iterations; }
    WeightCoefficients coefficients() const {
        WeightCoefficients const& all = backend == EstimatorBackend::grip ? grip_weights : accelerator_weights;
        return in_box == InBoxTerm::none ? all.without_in_box() : all;
    }
};

/// What the host needs besides the accelerator; keys `host.*`.
struct HostConfig {
    double start_us = 20;
    double collect_us = 30;
    double resample_us = 2000;
    double refine_us = 800'000;  ///< once per estimate, if it is refined
};

}  // namespace faster
