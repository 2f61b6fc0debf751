#pragma once
#include "faster/data/image.hpp"
#include "faster/workload/pictures/colour.hpp"
#include "poses/judging/evaluation.hpp"

namespace faster::poses {

enum class CurveOf { add_s, add };

/// Accuracy over the threshold from 0 to 10 cm, a panel per object and one for all, a line per method with its area:
/// figures 6.2 and 6.3 of the thesis.
Image<Colour> accuracy_plot(Evaluation const& evaluation, CurveOf error);

}  // namespace faster::poses
