#include <limits>

#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/key_builders.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/config/faster_keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

using Make = KeyMaker<FasterConfig>;

constexpr NumberRange share{0, 1};
constexpr NumberRange above_zero{0, std::numeric_limits<double>::infinity(), true};
constexpr NumberRange zero_or_more{0, std::numeric_limits<double>::infinity()};
constexpr NumberRange angle{0, 180};
constexpr char const* searched = "docs/pose-experiments.md";

void add_loop_keys(Keys& keys) {
    keys.push_back(Make::choice_key(
        {"estimator.backend", "",
         "Who scores the samples: the configured accelerator, or the thesis's baseline GRIP in software.",
         "thesis 6.1"},
        [](auto& config) -> auto& { return config.estimator.backend; }));
    keys.push_back(Make::integer_key(
        {"estimator.iterations", "iterations", "Iterations at most.", "thesis 4.2.1"}, {1, 100'000},
        [](auto& config) -> auto& { return config.estimator.iterations; }));
    keys.push_back(Make::integer_key(
        {"estimator.restarts", "runs",
         "Runs of all iterations that know nothing of each other, with seeds that follow each other; the heaviest "
         "estimate is kept.",
         "docs/poses.md"},
        {1, 1000}, [](auto& config) -> auto& { return config.estimator.restarts; }));
    keys.push_back(Make::choice_key(
        {"estimator.refine", "",
         "icp: the host moves the estimate so that the object's surface lies in the readings (iterative closest "
         "points).",
         "docs/poses.md"},
        [](auto& config) -> auto& { return config.estimator.refine; }));
    keys.push_back(Make::number_key(
        {"estimator.stop_weight", "", "The loop, and all runs, end once the best weight reaches this.", searched},
        zero_or_more, [](auto& config) -> auto& { return config.estimator.stop_weight; }));
    keys.push_back(Make::number_key(
        {"estimator.least_weight", "", "An estimate of less weight is reported as not found.", searched}, zero_or_more,
        [](auto& config) -> auto& { return config.estimator.least_weight; }));
    keys.push_back(Make::choice_key(
        {"estimator.estimate", "",
         "What the estimate is: the pose of the largest weight, or the weighted mean of the poses close to it.",
         "docs/poses.md"},
        [](auto& config) -> auto& { return config.estimator.estimate; }));
    keys.push_back(Make::integer_key(
        {"estimator.seed", "", "Seed of all that the loop draws.", "this project"}, IntegerRange{},
        [](auto& config) -> auto& { return config.estimator.seed; }));
    keys.push_back(Make::number_key(
        {"estimator.cluster.translation_m", "m", "Mean: how far a pose may be from the best one.", "this project"},
        zero_or_more, [](auto& config) -> auto& { return config.estimator.cluster_translation_m; }));
    keys.push_back(Make::number_key(
        {"estimator.cluster.rotation_deg", "degrees", "Mean: by how much a pose may be turned from the best one.",
         "this project"},
        angle, [](auto& config) -> auto& { return config.estimator.cluster_rotation_deg; }));
}

template <class Field> Key coefficient_key(std::string const& name, std::string const& of, Field field) {
    return Make::number_key({"estimator.weights." + name, "", "Eq. 2.4: coefficient of " + of + ".", searched}, share,
                            field);
}

void add_weight_keys(Keys& keys) {
    keys.push_back(Make::choice_key(
        {"estimator.weights.in_box", "",
         "How I_b is had, by accelerator and grip alike: I_r times the overlap of the sample's and the detection's "
         "box, inliers in the box as a share of all rendered points (eq. 2.3), or of those in the box, or not at all.",
         searched},
        [](auto& config) -> auto& { return config.estimator.in_box; }));
    keys.push_back(coefficient_key(
        "accelerator.box", "w_box, the confidence of its box; the four of accelerator are 1 together",
        [](auto& config) -> auto& { return config.estimator.accelerator_weights.box; }));
    keys.push_back(coefficient_key(
        "accelerator.in_box", "I_b (estimator.weights.in_box)",
        [](auto& config) -> auto& { return config.estimator.accelerator_weights.in_box; }));
    keys.push_back(coefficient_key(
        "accelerator.raw", "I_r = inlier / (valid_raster - estimator.weights.hidden x hidden)",
        [](auto& config) -> auto& { return config.estimator.accelerator_weights.raw; }));
    keys.push_back(coefficient_key(
        "accelerator.edge", "I_e = edge_inlier / valid_edge",
        [](auto& config) -> auto& { return config.estimator.accelerator_weights.edge; }));
    keys.push_back(Make::number_key(
        {"estimator.weights.hidden", "",
         "With accelerator.inlier_unit.hidden counted: share of the hidden pixels that I_r does not take for drawn; 0: "
         "as if they contradicted.",
         searched},
        share, [](auto& config) -> auto& { return config.estimator.hidden; }));
    keys.push_back(Make::boolean_key(
        {"estimator.weights.visible_box", "",
         "With accelerator.inlier_unit.hidden counted: whether the sample's box is that of drawn, not hidden pixels, "
         "and not that of the whole object.",
         searched},
        [](auto& config) -> auto& { return config.estimator.visible_box; }));
    keys.push_back(Make::integer_key(
        {"estimator.weights.least_drawn_px", "draws",
         "A sample that draws fewer fragments (accelerator) or points (grip) has no inlier ratios.", "this project"},
        {0, 1'000'000'000}, [](auto& config) -> auto& { return config.estimator.least_drawn_px; }));
    keys.push_back(coefficient_key(
        "grip.box", "w_box, the confidence of its box; the five of grip are 1 together",
        [](auto& config) -> auto& { return config.estimator.grip_weights.box; }));
    keys.push_back(coefficient_key(
        "grip.in_box", "I_b (estimator.weights.in_box)",
        [](auto& config) -> auto& { return config.estimator.grip_weights.in_box; }));
    keys.push_back(coefficient_key(
        "grip.raw", "I_r, that of all points",
        [](auto& config) -> auto& { return config.estimator.grip_weights.raw; }));
    keys.push_back(coefficient_key(
        "grip.edge", "I_e, that of edges", [](auto& config) -> auto& { return config.estimator.grip_weights.edge; }));
    keys.push_back(coefficient_key(
        "grip.planar", "I_p, that of planar points",
        [](auto& config) -> auto& { return config.estimator.grip_weights.planar; }));
    keys.push_back(Make::number_key(
        {"estimator.weights.grip.inlier_distance_m", "m", "Points closer than this agree (eq. 2.1).", "thesis A.3"},
        above_zero, [](auto& config) -> auto& { return config.estimator.grip_inlier_distance_m; }));
}

void add_resampling_keys(Keys& keys) {
    keys.push_back(Make::choice_key(
        {"estimator.resampling.method", "", "How samples are drawn in proportion to weight^sharpness.",
         "docs/poses.md"},
        [](auto& config) -> auto& { return config.estimator.resampling; }));
    keys.push_back(Make::number_key(
        {"estimator.resampling.sharpness", "", "Exponent of the weights.", searched}, {0, 1000},
        [](auto& config) -> auto& { return config.estimator.sharpness; }));
}

void add_diffusion_keys(Keys& keys) {
    keys.push_back(Make::number_key(
        {"estimator.diffusion.translation_sigma_m", "m", "Deviation of the noise per axis, after the first iteration.",
         searched},
        zero_or_more, [](auto& config) -> auto& { return config.estimator.diffusion.translation_sigma_m; }));
    keys.push_back(Make::number_key(
        {"estimator.diffusion.translation_sigma_min_m", "m", "The least that decay leaves of it.", searched},
        zero_or_more, [](auto& config) -> auto& { return config.estimator.diffusion.translation_sigma_min_m; }));
    keys.push_back(Make::number_key(
        {"estimator.diffusion.rotation_sigma_deg", "degrees",
         "Deviation of the angle of the noise about a random axis, after the first iteration.", searched},
        angle, [](auto& config) -> auto& { return config.estimator.diffusion.rotation_sigma_deg; }));
    keys.push_back(Make::number_key(
        {"estimator.diffusion.rotation_sigma_min_deg", "degrees", "The least that decay leaves of it.", searched},
        angle, [](auto& config) -> auto& { return config.estimator.diffusion.rotation_sigma_min_deg; }));
    keys.push_back(Make::number_key(
        {"estimator.diffusion.decay", "", "Both deviations are multiplied by this from iteration to iteration.",
         searched},
        share, [](auto& config) -> auto& { return config.estimator.diffusion.decay; }));
}

void add_box_keys(Keys& keys) {
    keys.push_back(Make::number_key(
        {"estimator.box.left", "px", "First column of the box in which the first stage found the object.",
         "thesis 2.1"},
        {}, [](auto& config) -> auto& { return config.estimator.box.left; }));
    keys.push_back(Make::number_key(
        {"estimator.box.top", "px", "Its first row.", "thesis 2.1"}, {},
        [](auto& config) -> auto& { return config.estimator.box.top; }));
    keys.push_back(Make::number_key(
        {"estimator.box.width", "px", "Its columns; 0: the box around the object under workload.pose.", "thesis 2.1"},
        zero_or_more, [](auto& config) -> auto& { return config.estimator.box.width; }));
    keys.push_back(Make::number_key(
        {"estimator.box.height", "px", "Its rows; 0 as its columns.", "thesis 2.1"}, zero_or_more,
        [](auto& config) -> auto& { return config.estimator.box.height; }));
    keys.push_back(Make::number_key(
        {"estimator.box.confidence", "", "w_box, how sure the first stage is.", "thesis 2.1"}, share,
        [](auto& config) -> auto& { return config.estimator.box.confidence; }));
}

void add_host_keys(Keys& keys) {
    keys.push_back(Make::number_key(
        {"host.start_us", "us", "From the last pose written to the accelerator's first cycle.", "this project"},
        zero_or_more, [](auto& config) -> auto& { return config.host.start_us; }));
    keys.push_back(Make::number_key(
        {"host.collect_us", "us", "From the accelerator's last cycle until the host has the counters.", "this project"},
        zero_or_more, [](auto& config) -> auto& { return config.host.collect_us; }));
    keys.push_back(Make::number_key(
        {"host.resample_us", "us", "Weights, resampling and diffusion of an iteration on the host's processor.",
         "measured, docs/pose-experiments.md"},
        zero_or_more, [](auto& config) -> auto& { return config.host.resample_us; }));
    keys.push_back(Make::number_key(
        {"host.refine_us", "us", "estimator.refine on the host's processor, once per estimate.",
         "measured, docs/pose-experiments.md"},
        zero_or_more, [](auto& config) -> auto& { return config.host.refine_us; }));
}

}  // namespace

Keys estimator_keys() {
    Keys keys;
    add_loop_keys(keys);
    add_weight_keys(keys);
    add_resampling_keys(keys);
    add_diffusion_keys(keys);
    add_box_keys(keys);
    add_host_keys(keys);
    for (Key& key : keys)
        key.of_runs = false;
    return keys;
}

}  // namespace faster
