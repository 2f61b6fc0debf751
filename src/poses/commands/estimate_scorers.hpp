#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/run/config/run_config.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/workload_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/commands/estimate_report.hpp"
#include "poses/commands/timed_iterations.hpp"
#include "poses/estimation/scene.hpp"
#include "poses/estimation/weight_terms.hpp"
#include "poses/grip/score_poses.hpp"

namespace faster {

/// Scores the samples of one iteration after the other.
class IterationScorer {
  public:
    virtual ~IterationScorer() = default;
    virtual std::vector<estimation::WeightTerms> score(std::vector<estimation::Particle> const& particles) = 0;
    /// The last iteration's; without counters if nothing counts.
    ScoredPoses const& last() const { return last_; }

  protected:
    ScoredPoses last_;
};

/// That of `estimator.backend`, on `jobs` threads. `scene` must outlive it; its samples change.
std::unique_ptr<IterationScorer> make_scorer(RunConfig const& config, estimation::Scene& scene, std::size_t jobs);

/// A scorer that simulates the configured accelerator itself, whose time is told on the way: what the last iteration
/// cost is in `cost`. All three must outlive it. score() throws DeadlockedIteration. Nothing is compared with the
/// untimed counters.
std::unique_ptr<IterationScorer> make_simulating_scorer(LoadedConfig const& loaded, estimation::Scene& scene,
                                                        IterationCost& cost);

/// Of GRIP: edges are found as the workload's are.
grip::Settings grip_settings(WorkloadConfig const& workload, double inlier_distance_m);

/// What people call a design: the preset, or the flow that was chosen on its own.
std::string design_name(Flow flow, std::string const& architecture);

/// That of the accelerator, or grip.
std::string scorer_name(RunConfig const& config);

/// The pose of an estimate, refined if that is configured.
Pose final_pose(estimation::Scene const& scene, estimation::Particle const& particle, EstimatorConfig const& config);

/// What an estimate of that weight is worth.
Verdict verdict_of(estimation::Scene const& scene, double weight, EstimatorConfig const& config);

/// The true pose that is nearest to a pose, by ADD-S; null if none is known.
estimation::TruePose const* nearest_truth(estimation::Scene const& scene, Pose const& pose);

/// ADD and ADD-S of a pose, by the scene's judged points, each from the nearest true pose; nothing if none is known.
std::optional<PoseDistances> distances_from_truth(estimation::Scene const& scene, Pose const& pose);

}  // namespace faster
