#pragma once
#include <string>

#include "kernel/sweeps/journal.hpp"
#include "kernel/sweeps/manifest.hpp"

namespace faster::sweeps {

/// index.html: one page that needs nothing else, with the Pareto front of two figures, parallel coordinates and a
/// table. Equal results give equal bytes.
std::string sweep_page(Manifest const& manifest, Results const& results);

}  // namespace faster::sweeps
