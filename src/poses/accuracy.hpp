#pragma once
#include <cstddef>
#include <vector>

namespace faster::poses {

/// An error [m], and how often it counts.
struct WeightedError {
    double error_m = 0;
    double weight = 1;
};

/// Area under the curve of accuracy (the share of instances with an error of at most x) over x from 0 to 0.1 m, of the
/// whole: 0..1. Exactly as the toolbox of YCB-Video has it (plot_accuracy_keyframe.m, VOCap): errors above 0.1 m are
/// infinite; sorted, the i-th of n stands at accuracy i / n; and from each error down to the one before, the curve has
/// the height of the *right* end. So n errors of 0.1 m make 1 / n and not 0.
/// `errors` ascend and are at most 0.1 m; `total` is the weight of all instances, those beyond 0.1 m included.
double area_under_accuracy(std::vector<WeightedError> const& errors, double total);

/// The same of plain errors in any order, infinite ones among them.
double area_under_accuracy(std::vector<double> errors_m);

}  // namespace faster::poses
