#pragma once
#include <string>

#include "kernel/compare/comparison.hpp"

namespace faster::runs {

/// The whole comparison as a JSON file (docs/formats.md, "Comparison of two runs").
std::string comparison_json(Comparison const& comparison);

}  // namespace faster::runs
