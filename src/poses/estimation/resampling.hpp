#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/base/counter_random.hpp"
#include "faster/config/estimator_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/estimation/particle.hpp"

namespace faster::estimation {

/// Deviations of one iteration's noise.
struct NoiseLevel {
    double translation_m = 0;
    double rotation_rad = 0;
};

/// max(sigma_min, sigma * decay^iteration); the power by repeated multiplication.
NoiseLevel noise_of(DiffusionConfig const& config, std::uint64_t iteration);

/// The particle moved by normal noise per axis (x, y, z) and then turned about its middle: a normal angle about an axis
/// of uniform direction.
Particle diffused(Particle const& particle, NoiseLevel const& noise, CounterRandom& random);

/// weight^sharpness of each, divided by their sum; all alike if they are all 0. At least one weight, none negative.
std::vector<double> shares_of(std::vector<double> const& weights, double sharpness);

/// 1 / sum of squares: how many samples of equal share would be as good.
double effective_sample_size(std::vector<double> const& shares);

/// `count` indices, drawn in proportion to `shares`, which add up to 1. In ascending order but for multinomial.
///   systematic   one u: the index in whose stretch of the running sum (i + u) / count lies, for i = 0, 1, ...
///   stratified   the same with a u of its own for every i
///   multinomial  count times the index in whose stretch u lies
std::vector<std::size_t> resampled(std::vector<double> const& shares, std::size_t count, Resampling method,
                                   CounterRandom& random);

}  // namespace faster::estimation
