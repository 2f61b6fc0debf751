#pragma once
#include <string>

#include "dataflow/tools/sweeps/manifest.hpp"
#include "dataflow/tools/sweeps/point_result.hpp"

namespace dataflow::sweeps {

/// index.html: one page that needs nothing else, with the Pareto front of two figures, parallel coordinates and a
/// table. Equal results give equal bytes.
std::string sweep_page(Manifest const& manifest, Results const& results);

}  // namespace dataflow::sweeps
