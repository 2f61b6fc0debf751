#include "estimation/diffusion.hpp"

#include <algorithm>

#include "kernel/base/portable_math.hpp"

namespace faster::estimation {

NoiseLevel noise_of(DiffusionConfig const& config, std::uint64_t iteration) {
    double power = 1;
    for (std::uint64_t k = 0; k < iteration && power > 0; ++k)
        power *= config.decay;
    double const degrees = std::max(config.rotation_sigma_min_deg, config.rotation_sigma_deg * power);
    return {std::max(config.translation_sigma_min_m, config.translation_sigma_m * power), degrees * portable::pi / 180};
}

Particle diffused(Particle const& particle, NoiseLevel const& noise, CounterRandom& random) {
    Particle moved = particle;
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        moved.middle(axis) += noise.translation_m * random.normal();
    moved.rotation = normalized(product(random_turn(random, noise.rotation_rad), particle.rotation));
    return moved;
}

}  // namespace faster::estimation
