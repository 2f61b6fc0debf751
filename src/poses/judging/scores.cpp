#include "poses/judging/scores.hpp"

#include <algorithm>
#include <limits>

namespace faster::poses {

namespace {

constexpr double percent = 100;

double share_below(std::vector<WeightedError> const& errors, double limit_m, double total) {
    double counted = 0;
    for (auto const& [error_m, weight] : errors)
        counted += error_m < limit_m ? weight : 0;
    return counted / total;
}

}  // namespace

double area_under_accuracy(std::vector<WeightedError> const& errors, double total) {
    double area = 0, last_m = 0, counted = 0;
    for (auto const& [error_m, weight] : errors) {
        if (weight > 0) {
            area += (error_m - last_m) * (counted + 1);
            last_m = error_m;
            counted += weight;
        }
    }
    area += (largest_add_m - last_m) * counted;
    return area / (largest_add_m * total);
}

double area_under_accuracy(std::vector<double> errors_m) {
    std::sort(errors_m.begin(), errors_m.end());
    std::vector<WeightedError> finite;
    for (double const error_m : errors_m) {
        if (error_m <= largest_add_m)
            finite.push_back({error_m, 1});
    }
    return area_under_accuracy(finite, static_cast<double>(errors_m.size()));
}

ScoredInstances::ScoredInstances(std::vector<InstanceErrors> const& instances,
                                 std::vector<std::size_t> const& image_numbers) {
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].add_m <= largest_add_m)
            add_.push_back({instances[i].add_m, image_numbers[i]});
        if (instances[i].add_s_m <= largest_add_m)
            add_s_.push_back({instances[i].add_s_m, image_numbers[i]});
        mssd_.push_back({instances[i].mssd_hits, image_numbers[i]});
    }
    for (auto* const errors : {&add_, &add_s_})
        std::stable_sort(errors->begin(), errors->end(),
                         [](Numbered const& a, Numbered const& b) { return a.error_m < b.error_m; });
}

std::vector<WeightedError> ScoredInstances::weighted(std::vector<Numbered> const& errors, ImageWeights const& weights) {
    std::vector<WeightedError> result;
    result.reserve(errors.size());
    for (auto const& [error_m, image] : errors)
        result.push_back({error_m, weights[image]});
    return result;
}

Scores ScoredInstances::scores(ImageWeights const& weights) const {
    double total = 0, hits = 0;
    for (Hits const& instance : mssd_) {
        total += weights[instance.image];
        hits += weights[instance.image] * instance.hits;
    }
    Scores scores{};
    if (!(total > 0)) {
        scores.fill(std::numeric_limits<double>::quiet_NaN());
        return scores;
    }
    auto const add = weighted(add_, weights), add_s = weighted(add_s_, weights);
    scores = {area_under_accuracy(add_s, total), area_under_accuracy(add, total), share_below(add_s, 0.02, total),
              share_below(add_s, 0.04, total),   share_below(add, 0.02, total),   share_below(add, 0.04, total),
              hits / (mssd_thresholds * total)};
    for (double& score : scores)
        score *= percent;
    return scores;
}

}  // namespace faster::poses
