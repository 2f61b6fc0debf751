#include "poses/commands/estimate_scorers.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "dataflow/base/on_threads.hpp"
#include "dataflow/run/config/choice_names.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "poses/estimation/counter_scorer.hpp"
#include "poses/estimation/icp.hpp"
#include "poses/grip/score_poses.hpp"
#include "poses/judging/pose_error.hpp"

namespace faster {

namespace {

double confidence_of(estimation::Scene const& scene, estimation::Particle const& particle) {
    return scene.boxes.empty() ? 0 : scene.boxes[particle.box].confidence;
}

estimation::BoxFit fit_of(DetectionConfig const& covered, DetectionConfig const& box) {
    return {estimation::overlap_share(covered, box), estimation::share_inside(covered, box)};
}

/// By the few vertices that reach furthest.
estimation::BoxFit fit_of(estimation::Scene const& scene, estimation::Particle const& particle, Pose const& pose) {
    if (scene.boxes.empty())
        return {};
    return fit_of(estimation::box_around(scene.size.outline, pose, scene.observed.posed.camera),
                  scene.boxes[particle.box]);
}

bool counts_hidden(RunConfig const& config) {
    return estimator_of(config).backend == EstimatorBackend::accelerator &&
           counts_hidden(accelerator_of(config).inlier_unit);
}

estimation::TermSettings term_settings_of(RunConfig const& config) {
    return {estimator_of(config).in_box, estimator_of(config).least_drawn_px,
            counts_hidden(config) ? estimator_of(config).hidden : 0};
}

std::vector<Pose> poses_of(estimation::Scene const& scene, std::vector<estimation::Particle> const& particles) {
    std::vector<Pose> poses;
    poses.reserve(particles.size());
    for (estimation::Particle const& particle : particles)
        poses.push_back(pose_of(particle, scene.size));
    return poses;
}

/// By the accelerator's counters.
class AcceleratorScorer final : public IterationScorer {
  public:
    /// Of the scene's samples as they are now.
    using Count = std::function<std::vector<SampleCounters>()>;

    AcceleratorScorer(RunConfig const& config, estimation::Scene& scene, Count count)
        : scene_(scene),
          settings_(term_settings_of(config)),
          has_visible_box_(counts_hidden(config) && estimator_of(config).visible_box),
          count_(std::move(count)) {}

    std::vector<estimation::WeightTerms> score(std::vector<estimation::Particle> const& particles) override {
        last_.poses = poses_of(scene_, particles);
        workload::set_poses(last_.poses, scene_.observed);
        last_.counters = count_();
        std::vector<estimation::WeightTerms> terms;
        for (std::size_t i = 0; i < particles.size(); ++i)
            terms.push_back(estimation::terms_of(last_.counters[i], confidence_of(scene_, particles[i]),
                                                 fit(particles[i], i), settings_));
        return terms;
    }

  private:
    estimation::BoxFit fit(estimation::Particle const& particle, std::size_t i) const {
        if (!has_visible_box_ || scene_.boxes.empty())
            return fit_of(scene_, particle, last_.poses[i]);
        return fit_of(estimation::visible_box(last_.counters[i], scene_.observed.samples[i], scene_.observed.window),
                      scene_.boxes[particle.box]);
    }

    estimation::Scene& scene_;
    estimation::TermSettings settings_;
    bool has_visible_box_;
    Count count_;
};

class GripScorer final : public IterationScorer {
  public:
    GripScorer(RunConfig const& config, estimation::Scene& scene, std::size_t jobs)
        : scene_(scene),
          settings_(term_settings_of(config)),
          jobs_(jobs),
          scorer_(scene.observed, grip_settings(workload_of(config), estimator_of(config).grip_inlier_distance_m)) {}

    std::vector<estimation::WeightTerms> score(std::vector<estimation::Particle> const& particles) override {
        last_.poses = poses_of(scene_, particles);
        std::vector<estimation::WeightTerms> terms(particles.size());
        on_threads(particles.size(), jobs_, [&](std::size_t i) {
            terms[i] = estimation::terms_of(scorer_.score(last_.poses[i], area_of(particles[i])),
                                            confidence_of(scene_, particles[i]),
                                            fit_of(scene_, particles[i], last_.poses[i]), settings_);
        });
        return terms;
    }

  private:
    grip::PixelArea area_of(estimation::Particle const& particle) const {
        if (scene_.boxes.empty())
            return {};
        DetectionConfig const& box = scene_.boxes[particle.box];
        return {box.left, box.top, box.left + box.width, box.top + box.height};
    }

    estimation::Scene& scene_;
    estimation::TermSettings settings_;
    std::size_t jobs_;
    grip::PoseScorer scorer_;
};

poses::Points const& judged_points(estimation::Scene const& scene) {
    return scene.judged_points.empty() ? scene.observed.posed.mesh.vertices : scene.judged_points;
}

}  // namespace

std::unique_ptr<IterationScorer> make_scorer(RunConfig const& config, estimation::Scene& scene, std::size_t jobs) {
    if (estimator_of(config).backend == EstimatorBackend::grip)
        return std::make_unique<GripScorer>(config, scene, jobs);
    auto const scorer = std::make_shared<estimation::CounterScorer>(scene.observed, accelerator_of(config), jobs);
    return std::make_unique<AcceleratorScorer>(config, scene, [scorer] { return scorer->score(); });
}

std::unique_ptr<IterationScorer> make_simulating_scorer(LoadedConfig const& loaded, estimation::Scene& scene,
                                                        IterationCost& cost) {
    auto const count = [&loaded, &scene, &cost, number = std::size_t{0}]() mutable {
        SimulatedIteration iteration = simulate_iteration(loaded, scene.observed, number++);
        cost = iteration.cost;
        return std::move(iteration.counters);
    };
    return std::make_unique<AcceleratorScorer>(loaded.config, scene, count);
}

grip::Settings grip_settings(WorkloadConfig const& workload, double inlier_distance_m) {
    return {workload.observed_edges.neighbourhood, workload.observed_edges.threshold, inlier_distance_m};
}

std::string design_name(Flow flow, std::string const& architecture) {
    return flow == Flow::faster ? architecture : choice_name(flow);
}

std::string scorer_name(RunConfig const& config) {
    if (estimator_of(config).backend == EstimatorBackend::grip)
        return "grip";
    AcceleratorConfig const& accelerator = accelerator_of(config);
    return design_name(accelerator.flow, accelerator.architecture);
}

Pose final_pose(estimation::Scene const& scene, estimation::Particle const& particle, EstimatorConfig const& config) {
    Pose const pose = pose_of(particle, scene.size);
    return config.refine == Refinement::icp ? estimation::refined_by_icp(scene.observed, pose) : pose;
}

Verdict verdict_of(estimation::Scene const& scene, double weight, EstimatorConfig const& config) {
    bool const is_blind = std::all_of(scene.boxes.begin(), scene.boxes.end(), [&](DetectionConfig const& box) {
        return estimation::readings_in(box, scene.observed.observed_depth) == 0;
    });
    if (!scene.boxes.empty() && is_blind)
        return Verdict::no_readings;
    return weight < config.least_weight ? Verdict::weak : Verdict::found;
}

estimation::TruePose const* nearest_truth(estimation::Scene const& scene, Pose const& pose) {
    if (scene.truths.size() < 2)
        return scene.truths.empty() ? nullptr : &scene.truths.front();
    std::vector<double> apart;
    for (estimation::TruePose const& truth : scene.truths)
        apart.push_back(poses::add_s(judged_points(scene), pose, truth.pose));
    return &scene.truths[static_cast<std::size_t>(std::min_element(apart.begin(), apart.end()) - apart.begin())];
}

std::optional<PoseDistances> distances_from_truth(estimation::Scene const& scene, Pose const& pose) {
    std::optional<PoseDistances> least;
    for (estimation::TruePose const& truth : scene.truths) {
        PoseDistances const off{poses::add(judged_points(scene), pose, truth.pose),
                                poses::add_s(judged_points(scene), pose, truth.pose)};
        least = least ? PoseDistances{std::min(least->add_m, off.add_m), std::min(least->adds_m, off.adds_m)} : off;
    }
    return least;
}

}  // namespace faster
