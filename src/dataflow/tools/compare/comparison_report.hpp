#pragma once
#include <cstddef>
#include <string>

#include "dataflow/tools/compare/comparison.hpp"

namespace dataflow::runs {

/// The whole comparison as a JSON file (docs/formats.md, "Comparison of two runs").
std::string comparison_json(Comparison const& comparison);

/// The comparison for people: configuration, headline, results, then what moved, a table per kind that has changes.
/// Each list ends after `top` rows with a line that says how many were left out. Identical runs are one line.
std::string comparison_text(Comparison const& comparison, std::size_t top);

}  // namespace dataflow::runs
