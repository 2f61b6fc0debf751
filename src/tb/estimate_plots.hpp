#pragma once
#include <vector>

#include "common/image.hpp"
#include "tb/estimate_report.hpp"
#include "workload/pictures/colour.hpp"

namespace faster {

/// How an estimate went: weights, effective samples, spread and, if the truth is known, errors over the iterations.
Image<Colour> estimate_plots(std::vector<IterationRow> const& iterations);

}  // namespace faster
