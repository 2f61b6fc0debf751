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

double plain_area_under_accuracy(std::vector<WeightedError> const& errors, double total) {
    double area = 0;
    for (auto const& [error_m, weight] : errors)
        area += weight * (1 - error_m / largest_add_m);
    return area / total;
}

ScoredInstances::ScoredInstances(std::vector<InstanceErrors> const& instances,
                                 std::vector<std::size_t> const& image_numbers) {
    for (std::size_t i = 0; i < instances.size(); ++i) {
        if (instances[i].add_m <= largest_add_m)
            add_.push_back({instances[i].add_m, image_numbers[i]});
        if (instances[i].add_s_m <= largest_add_m)
            add_s_.push_back({instances[i].add_s_m, image_numbers[i]});
        mssd_.push_back({instances[i].mssd_hits / (1.0 * recall_thresholds), image_numbers[i]});
        mspd_.push_back({instances[i].mspd_hits / (1.0 * recall_thresholds), image_numbers[i]});
        vsd_.push_back({instances[i].vsd_recall.value_or(std::numeric_limits<double>::quiet_NaN()), image_numbers[i]});
    }
    for (auto* const errors : {&add_, &add_s_})
        std::stable_sort(errors->begin(), errors->end(),
                         [](Numbered const& a, Numbered const& b) { return a.error_m < b.error_m; });
    add_more_ = more_by_toolbox(add_);
    add_s_more_ = more_by_toolbox(add_s_);
}

double ScoredInstances::more_by_toolbox(std::vector<Numbered> const& errors) const {
    std::vector<WeightedError> once;
    once.reserve(errors.size());
    for (Numbered const& error : errors)
        once.push_back({error.error_m, 1});
    auto const total = static_cast<double>(mssd_.size());
    return area_under_accuracy(once, total) - plain_area_under_accuracy(once, total);
}

double ScoredInstances::mean(Recalls const& recalls, ImageWeights const& weights, double total) {
    double sum = 0;
    for (Recall const& instance : recalls)
        sum += weights[instance.image] > 0 ? weights[instance.image] * instance.share : 0;
    return sum / total;
}

std::vector<WeightedError> ScoredInstances::weighted(std::vector<Numbered> const& errors, ImageWeights const& weights) {
    std::vector<WeightedError> result;
    result.reserve(errors.size());
    for (auto const& [error_m, image] : errors)
        result.push_back({error_m, weights[image]});
    return result;
}

Scores ScoredInstances::scores(ImageWeights const& weights) const {
    double total = 0;
    for (Recall const& instance : mssd_)
        total += weights[instance.image];
    Scores scores{};
    if (!(total > 0)) {
        scores.fill(std::numeric_limits<double>::quiet_NaN());
        return scores;
    }
    auto const add = weighted(add_, weights), add_s = weighted(add_s_, weights);
    double const add_area = plain_area_under_accuracy(add, total), add_s_area = plain_area_under_accuracy(add_s, total);
    double const mssd = mean(mssd_, weights, total), mspd = mean(mspd_, weights, total),
                 vsd = mean(vsd_, weights, total);
    scores = {std::min(1.0, add_s_area + add_s_more_),
              std::min(1.0, add_area + add_more_),
              share_below(add_s, 0.02, total),
              share_below(add_s, 0.04, total),
              share_below(add, 0.02, total),
              share_below(add, 0.04, total),
              mssd,
              add_s_area,
              add_area,
              mspd,
              vsd,
              (vsd + mssd + mspd) / 3};
    for (double& score : scores)
        score *= percent;
    return scores;
}

}  // namespace faster::poses
