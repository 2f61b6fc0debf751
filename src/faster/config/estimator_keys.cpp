#include <limits>

#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/key_builders.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/config/faster_keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

constexpr NumberRange share{0, 1};
constexpr NumberRange above_zero{0, std::numeric_limits<double>::infinity(), true};
constexpr NumberRange zero_or_more{0, std::numeric_limits<double>::infinity()};
constexpr NumberRange angle{0, 180};
constexpr char const* searched = "docs/pose-experiments.md";

void add_loop_keys(Keys& keys) {
    auto estimator = key_section(keys, "estimator", &FasterConfig::estimator);
    estimator.choice("backend", "",
                     "Who scores the samples: the configured accelerator, or the thesis's baseline GRIP in software.",
                     "thesis 6.1", &EstimatorConfig::backend);
    estimator.integer("iterations", "iterations", "Iterations at most.", "thesis 4.2.1", {1, 100'000},
                      &EstimatorConfig::iterations);
    estimator.integer(
        "restarts", "runs",
        "Runs of all iterations that know nothing of each other, with seeds that follow each other; the heaviest "
        "estimate is kept.",
        "docs/poses.md", {1, 1000}, &EstimatorConfig::restarts);
    estimator.choice(
        "refine", "",
        "icp: the host moves the estimate so that the object's surface lies in the readings (iterative closest "
        "points).",
        "docs/poses.md", &EstimatorConfig::refine);
    estimator.number("stop_weight", "", "The loop, and all runs, end once the best weight reaches this.", searched,
                     zero_or_more, &EstimatorConfig::stop_weight);
    estimator.number("least_weight", "", "An estimate of less weight is reported as not found.", searched, zero_or_more,
                     &EstimatorConfig::least_weight);
    estimator.choice(
        "estimate", "",
        "What the estimate is: the pose of the largest weight, or the weighted mean of the poses close to it.",
        "docs/poses.md", &EstimatorConfig::estimate);
    estimator.integer("seed", "", "Seed of all that the loop draws.", "this project", {}, &EstimatorConfig::seed);
    estimator.number("cluster.translation_m", "m", "Mean: how far a pose may be from the best one.", "this project",
                     zero_or_more, &EstimatorConfig::cluster_translation_m);
    estimator.number("cluster.rotation_deg", "degrees", "Mean: by how much a pose may be turned from the best one.",
                     "this project", angle, &EstimatorConfig::cluster_rotation_deg);
}

template <class Section>
void add_coefficient(Section& weights, std::string const& name, std::string const& of,
                     double WeightCoefficients::*coefficient) {
    weights.number(name, "", "Eq. 2.4: coefficient of " + of + ".", searched, share, coefficient);
}

void add_weight_keys(Keys& keys) {
    auto weights = key_section(keys, "estimator.weights", &FasterConfig::estimator);
    auto accelerator = key_section(keys, "estimator.weights.accelerator", &FasterConfig::estimator,
                                   &EstimatorConfig::accelerator_weights);
    auto grip = key_section(keys, "estimator.weights.grip", &FasterConfig::estimator, &EstimatorConfig::grip_weights);
    weights.choice(
        "in_box", "",
        "How I_b is had, by accelerator and grip alike: I_r times the overlap of the sample's and the detection's "
        "box, inliers in the box as a share of all rendered points (eq. 2.3), or of those in the box, or not at all.",
        searched, &EstimatorConfig::in_box);
    add_coefficient(accelerator, "box", "w_box, the confidence of its box; the four of accelerator are 1 together",
                    &WeightCoefficients::box);
    add_coefficient(accelerator, "in_box", "I_b (estimator.weights.in_box)", &WeightCoefficients::in_box);
    add_coefficient(accelerator, "raw", "I_r = inlier / (valid_raster - estimator.weights.hidden x hidden)",
                    &WeightCoefficients::raw);
    add_coefficient(accelerator, "edge", "I_e = edge_inlier / valid_edge", &WeightCoefficients::edge);
    weights.number(
        "hidden", "",
        "With accelerator.inlier_unit.hidden counted: share of the hidden pixels that I_r does not take for drawn; 0: "
        "as if they contradicted.",
        searched, share, &EstimatorConfig::hidden);
    weights.boolean(
        "visible_box", "",
        "With accelerator.inlier_unit.hidden counted: whether the sample's box is that of drawn, not hidden pixels, "
        "and not that of the whole object.",
        searched, &EstimatorConfig::visible_box);
    weights.integer("least_drawn_px", "draws",
                    "A sample that draws fewer fragments (accelerator) or points (grip) has no inlier ratios.",
                    "this project", {0, 1'000'000'000}, &EstimatorConfig::least_drawn_px);
    add_coefficient(grip, "box", "w_box, the confidence of its box; the five of grip are 1 together",
                    &WeightCoefficients::box);
    add_coefficient(grip, "in_box", "I_b (estimator.weights.in_box)", &WeightCoefficients::in_box);
    add_coefficient(grip, "raw", "I_r, that of all points", &WeightCoefficients::raw);
    add_coefficient(grip, "edge", "I_e, that of edges", &WeightCoefficients::edge);
    add_coefficient(grip, "planar", "I_p, that of planar points", &WeightCoefficients::planar);
    weights.number("grip.inlier_distance_m", "m", "Points closer than this agree (eq. 2.1).", "thesis A.3", above_zero,
                   &EstimatorConfig::grip_inlier_distance_m);
}

void add_resampling_keys(Keys& keys) {
    auto resampling = key_section(keys, "estimator.resampling", &FasterConfig::estimator);
    resampling.choice("method", "", "How samples are drawn in proportion to weight^sharpness.", "docs/poses.md",
                      &EstimatorConfig::resampling);
    resampling.number("sharpness", "", "Exponent of the weights.", searched, {0, 1000}, &EstimatorConfig::sharpness);
}

void add_diffusion_keys(Keys& keys) {
    auto diffusion = key_section(keys, "estimator.diffusion", &FasterConfig::estimator, &EstimatorConfig::diffusion);
    diffusion.number("translation_sigma_m", "m", "Deviation of the noise per axis, after the first iteration.",
                     searched, zero_or_more, &DiffusionConfig::translation_sigma_m);
    diffusion.number("translation_sigma_min_m", "m", "The least that decay leaves of it.", searched, zero_or_more,
                     &DiffusionConfig::translation_sigma_min_m);
    diffusion.number("rotation_sigma_deg", "degrees",
                     "Deviation of the angle of the noise about a random axis, after the first iteration.", searched,
                     angle, &DiffusionConfig::rotation_sigma_deg);
    diffusion.number("rotation_sigma_min_deg", "degrees", "The least that decay leaves of it.", searched, angle,
                     &DiffusionConfig::rotation_sigma_min_deg);
    diffusion.number("decay", "", "Both deviations are multiplied by this from iteration to iteration.", searched,
                     share, &DiffusionConfig::decay);
}

void add_box_keys(Keys& keys) {
    auto box = key_section(keys, "estimator.box", &FasterConfig::estimator, &EstimatorConfig::box);
    box.number("left", "px", "First column of the box in which the first stage found the object.", "thesis 2.1", {},
               &DetectionConfig::left);
    box.number("top", "px", "Its first row.", "thesis 2.1", {}, &DetectionConfig::top);
    box.number("width", "px", "Its columns; 0: the box around the object under workload.pose.", "thesis 2.1",
               zero_or_more, &DetectionConfig::width);
    box.number("height", "px", "Its rows; 0 as its columns.", "thesis 2.1", zero_or_more, &DetectionConfig::height);
    box.number("confidence", "", "w_box, how sure the first stage is.", "thesis 2.1", share,
               &DetectionConfig::confidence);
}

void add_host_keys(Keys& keys) {
    auto host = key_section(keys, "host", &FasterConfig::host);
    host.number("start_us", "us", "From the last pose written to the accelerator's first cycle.", "this project",
                zero_or_more, &HostConfig::start_us);
    host.number("collect_us", "us", "From the accelerator's last cycle until the host has the counters.",
                "this project", zero_or_more, &HostConfig::collect_us);
    host.number("resample_us", "us", "Weights, resampling and diffusion of an iteration on the host's processor.",
                "measured, docs/pose-experiments.md", zero_or_more, &HostConfig::resample_us);
    host.number("refine_us", "us", "estimator.refine on the host's processor, once per estimate.",
                "measured, docs/pose-experiments.md", zero_or_more, &HostConfig::refine_us);
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
