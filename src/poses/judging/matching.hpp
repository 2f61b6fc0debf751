#pragma once
#include <cstddef>
#include <vector>

namespace faster::poses {

/// errors[e][g]: how far estimate e is from the true pose g; the estimate with the best score first.
using PairErrors = std::vector<std::vector<double>>;

/// Which estimate is whose: one after the other, an estimate takes the nearest true pose of those that are left and
/// nearer than `limit`. Returns the error of each true pose, infinity if none took it. As bop_toolkit does it.
std::vector<double> matched_below(PairErrors const& errors, std::size_t truths, double limit);

/// matched_below(); estimates and true poses that are left over are then matched without a limit, for the record.
std::vector<double> matched(PairErrors const& errors, std::size_t truths, double limit);

}  // namespace faster::poses
