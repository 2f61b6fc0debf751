#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "common/image.hpp"
#include "tb/experiment_failures.hpp"
#include "workload/pictures/colour.hpp"

namespace faster {

/// The worst failures of a setting by ADD-S, `most` at most, one of each reason in turn, so that all reasons show.
std::vector<Failure> worst_of(std::vector<Failure> const& failures, SettingData const& setting, std::size_t most);

/// They side by side: the depth image grey, near is light, observed edges blue, the outline of the true pose green,
/// that of the estimated one red. Each below its method, image and object, error, reason, and weight against the true
/// pose's.
Image<Colour> failure_sheet(std::vector<Failure> const& failures);

}  // namespace faster
