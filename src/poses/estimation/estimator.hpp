#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "poses/estimation/particle.hpp"
#include "poses/estimation/resampling.hpp"
#include "poses/estimation/scene.hpp"
#include "poses/estimation/weight_terms.hpp"

namespace faster::estimation {

/// Scores all samples of an iteration, one result per particle.
using Score = std::function<std::vector<WeightTerms>(std::vector<Particle> const&)>;

/// An iteration as it was scored.
struct Iteration {
    std::uint64_t run = 0;     ///< which of the runs it belongs to
    std::uint64_t number = 0;  ///< in its run
    std::vector<Particle> particles;
    std::vector<double> weights;
    std::size_t best = 0;  ///< the first sample of the largest weight
    double mean_weight = 0;
    double effective_samples = 0;  ///< of weight^sharpness
    double spread_m = 0;           ///< root mean square of the middles' distances from their mean
    double spread_rad = 0;         ///< root mean square of the angles to the best sample
    NoiseLevel noise;              ///< that made its samples; 0 in the first

    double best_weight() const { return weights[best]; }
};

/// Why the loop ended.
enum class Ending { iterations, stop_weight };

struct Estimate {
    Particle particle;
    double weight = 0;
    Ending ending = Ending::iterations;
    std::uint64_t iterations = 0;  ///< that were scored, in all runs
    std::uint64_t runs = 1;        ///< that were made
    std::uint64_t run = 0;         ///< that it is of: the first of the heaviest
};

/// The loop of docs/poses.md#the-loop: score, stop or resample, diffuse. The best sample stays sample 0, unchanged, and
/// the other samples are drawn. Run r of `restarts` draws with seed + r. `count` >= 1. `done` is told of every
/// iteration. `score_mean`: what scores the mean, which is no iteration; empty: `score`.
Estimate estimate(Scene const& scene, EstimatorConfig const& config, std::size_t count, Score const& score,
                  std::function<void(Iteration const&)> const& done = {}, Score const& score_mean = {});

/// The weighted mean of the particles close to `best`: of middles, and of quaternions, turned to its side and
/// normalized. Weights as in resampling.
Particle cluster_mean(Iteration const& iteration, EstimatorConfig const& config);

}  // namespace faster::estimation
