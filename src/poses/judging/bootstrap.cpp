#include "poses/judging/bootstrap.hpp"

#include <algorithm>
#include <cmath>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::poses {
namespace {

/// Of ascending numbers.
double quantile(std::vector<double> const& numbers, double share) {
    double const place = share * static_cast<double>(numbers.size() - 1);
    auto const below = static_cast<std::size_t>(place);
    std::size_t const above = std::min(below + 1, numbers.size() - 1);
    return numbers[below] + (place - static_cast<double>(below)) * (numbers[above] - numbers[below]);
}

}  // namespace

std::vector<ImageWeights> drawn_images(std::size_t images, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    std::vector<ImageWeights> draws(count, ImageWeights(images, 0));
    for (ImageWeights& weights : draws) {
        for (std::size_t i = 0; i < images; ++i) {
            auto const image = static_cast<std::size_t>(random.uniform() * static_cast<double>(images));
            weights[std::min(image, images - 1)] += 1;
        }
    }
    return draws;
}

Interval interval_of(double value, std::vector<double> replicates) {
    replicates.erase(std::remove_if(replicates.begin(), replicates.end(), [](double r) { return std::isnan(r); }),
                     replicates.end());
    if (replicates.empty())
        return {value, value, value};
    std::sort(replicates.begin(), replicates.end());
    return {value, std::min(value, quantile(replicates, 0.025)), std::max(value, quantile(replicates, 0.975))};
}

}  // namespace faster::poses
