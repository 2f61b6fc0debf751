#include "poses/estimation/resampling.hpp"

#include <algorithm>

#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::estimation {

namespace {

std::vector<double> running_sums(std::vector<double> const& shares) {
    std::vector<double> sums;
    sums.reserve(shares.size());
    double sum = 0;
    for (double const share : shares)
        sums.push_back(sum += share);
    return sums;
}

/// The last share that is not 0 takes what rounding leaves beyond the sum.
std::size_t index_at(std::vector<double> const& sums, double place) {
    auto const found = std::upper_bound(sums.begin(), sums.end(), place);
    if (found != sums.end())
        return static_cast<std::size_t>(found - sums.begin());
    return static_cast<std::size_t>(std::lower_bound(sums.begin(), sums.end(), sums.back()) - sums.begin());
}

}  // namespace

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

/// Relative to the largest, so that no power is too small for a double where it matters.
std::vector<double> shares_of(std::vector<double> const& weights, double sharpness) {
    double const largest = *std::max_element(weights.begin(), weights.end());
    std::vector<double> shares;
    double sum = 0;
    for (double const weight : weights) {
        shares.push_back(largest > 0 ? portable::pow(weight / largest, sharpness) : 1);
        sum += shares.back();
    }
    for (double& share : shares)
        share /= sum;
    return shares;
}

double effective_sample_size(std::vector<double> const& shares) {
    double squares = 0;
    for (double const share : shares)
        squares += share * share;
    return 1 / squares;
}

std::vector<std::size_t> resampled(std::vector<double> const& shares, std::size_t count, Resampling method,
                                   CounterRandom& random) {
    std::vector<double> const sums = running_sums(shares);
    double const common = method == Resampling::systematic ? random.uniform() : 0;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < count; ++i) {
        double const own = method == Resampling::systematic ? common : random.uniform();
        double const place =
            method == Resampling::multinomial ? own : (static_cast<double>(i) + own) / static_cast<double>(count);
        indices.push_back(index_at(sums, place));
    }
    return indices;
}

}  // namespace faster::estimation
