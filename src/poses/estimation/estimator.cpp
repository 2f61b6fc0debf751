#include "poses/estimation/estimator.hpp"

#include <algorithm>
#include <cmath>

#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/estimation/first_samples.hpp"
#include "poses/estimation/resampling.hpp"
#include "poses/estimation/streams.hpp"

namespace faster::estimation {

namespace {

double distance(Eigen::Vector3d const& a, Eigen::Vector3d const& b) {
    double const x = a.x() - b.x(), y = a.y() - b.y(), z = a.z() - b.z();
    return std::sqrt(x * x + y * y + z * z);
}

Eigen::Vector3d mean_middle(std::vector<Particle> const& particles) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Particle const& particle : particles)
        sum += particle.middle;
    return sum / static_cast<double>(particles.size());
}

void add_spread(Iteration& iteration) {
    Eigen::Vector3d const mean = mean_middle(iteration.particles);
    double squares_m = 0, squares_rad = 0;
    for (Particle const& particle : iteration.particles) {
        double const metres = distance(particle.middle, mean);
        double const radians = angle_between(particle.rotation, iteration.particles[iteration.best].rotation);
        squares_m += metres * metres;
        squares_rad += radians * radians;
    }
    auto const count = static_cast<double>(iteration.particles.size());
    iteration.spread_m = std::sqrt(squares_m / count);
    iteration.spread_rad = std::sqrt(squares_rad / count);
}

Iteration scored(std::uint64_t number, std::vector<Particle> particles, EstimatorConfig const& config,
                 Score const& score) {
    Iteration iteration;
    iteration.number = number;
    iteration.particles = std::move(particles);
    double sum = 0;
    for (WeightTerms const& terms : score(iteration.particles)) {
        iteration.weights.push_back(terms.weight(config.coefficients()));
        sum += iteration.weights.back();
    }
    iteration.best = static_cast<std::size_t>(std::max_element(iteration.weights.begin(), iteration.weights.end()) -
                                              iteration.weights.begin());
    iteration.mean_weight = sum / static_cast<double>(iteration.weights.size());
    iteration.effective_samples = effective_sample_size(shares_of(iteration.weights, config.sharpness));
    add_spread(iteration);
    return iteration;
}

std::vector<Particle> next_samples(Iteration const& iteration, EstimatorConfig const& config) {
    std::uint64_t const generation = iteration.number + 1;
    CounterRandom random = stream_of_resampling(config.seed, generation);
    std::vector<Particle> particles{iteration.particles[iteration.best]};
    NoiseLevel const noise = noise_of(config.diffusion, iteration.number);
    for (std::size_t const parent : resampled(shares_of(iteration.weights, config.sharpness),
                                              iteration.particles.size() - 1, config.resampling, random)) {
        CounterRandom own = stream_of_sample(config.seed, generation, particles.size());
        particles.push_back(diffused(iteration.particles[parent], noise, own));
    }
    return particles;
}

Estimate estimate_of(Iteration const& last, EstimatorConfig const& config, Score const& score) {
    Estimate estimate;
    estimate.particle = last.particles[last.best];
    estimate.weight = last.best_weight();
    estimate.iterations = last.number + 1;
    if (last.best_weight() >= config.stop_weight)
        estimate.ending = Ending::stop_weight;
    if (config.estimate == EstimateKind::mean) {
        estimate.particle = cluster_mean(last, config);
        estimate.weight = scored(last.number, {estimate.particle}, config, score).best_weight();
    }
    return estimate;
}

Estimate run_once(Scene const& scene, EstimatorConfig const& config, std::size_t count, Score const& score,
                  std::function<void(Iteration&)> const& done, Score const& score_mean) {
    std::vector<Particle> particles = first_samples(scene, count, config.seed);
    NoiseLevel noise;
    for (std::uint64_t number = 0;; ++number) {
        Iteration iteration = scored(number, std::move(particles), config, score);
        iteration.noise = noise;
        done(iteration);
        if (iteration.best_weight() >= config.stop_weight || number + 1 == config.iterations)
            return estimate_of(iteration, config, score_mean ? score_mean : score);
        particles = next_samples(iteration, config);
        noise = noise_of(config.diffusion, number);
    }
}

}  // namespace

Estimate estimate(Scene const& scene, EstimatorConfig const& config, std::size_t count, Score const& score,
                  std::function<void(Iteration const&)> const& done, Score const& score_mean) {
    Estimate heaviest;
    std::uint64_t run = 0, scored_iterations = 0;
    EstimatorConfig own = config;
    auto const tell = [&](Iteration& iteration) {
        iteration.run = run;
        if (done)
            done(iteration);
    };
    for (; run < config.restarts; ++run, ++own.seed) {
        Estimate const found = run_once(scene, own, count, score, tell, score_mean);
        scored_iterations += found.iterations;
        if (run == 0 || found.weight > heaviest.weight) {
            heaviest = found;
            heaviest.run = run;
        }
        heaviest.runs = run + 1;
        heaviest.iterations = scored_iterations;
        if (found.ending == Ending::stop_weight)
            break;
    }
    return heaviest;
}

Particle cluster_mean(Iteration const& iteration, EstimatorConfig const& config) {
    Particle const& best = iteration.particles[iteration.best];
    std::vector<double> const shares = shares_of(iteration.weights, config.sharpness);
    double const most_rad = config.cluster_rotation_deg * portable::pi / 180;
    Particle mean = best;
    mean.middle.setZero();
    mean.rotation = {0, 0, 0, 0};
    double sum = 0;
    for (std::size_t i = 0; i < shares.size(); ++i) {
        Particle const& particle = iteration.particles[i];
        if (distance(particle.middle, best.middle) > config.cluster_translation_m ||
            angle_between(particle.rotation, best.rotation) > most_rad)
            continue;
        double const side = dot(particle.rotation, best.rotation) < 0 ? -shares[i] : shares[i];
        mean.rotation = {mean.rotation.w + side * particle.rotation.w, mean.rotation.x + side * particle.rotation.x,
                         mean.rotation.y + side * particle.rotation.y, mean.rotation.z + side * particle.rotation.z};
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            mean.middle(axis) += shares[i] * particle.middle(axis);
        sum += shares[i];
    }
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        mean.middle(axis) /= sum;
    mean.rotation = normalized(mean.rotation);
    return mean;
}

}  // namespace faster::estimation
