#include "poses/accuracy.hpp"

#include <algorithm>

#include "poses/judge.hpp"

namespace faster::poses {

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

}  // namespace faster::poses
