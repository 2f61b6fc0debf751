#pragma once
#include <cstdint>

#include "estimation/particle.hpp"
#include "faster/estimator_config.hpp"

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

}  // namespace faster::estimation
