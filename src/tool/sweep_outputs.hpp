#pragma once
#include "kernel/sweeps/journal.hpp"
#include "kernel/sweeps/manifest.hpp"
#include "kernel/sweeps/sweep_folder.hpp"

namespace faster {

/// Writes table and page of a sweep, and says so. The points that failed are named on stderr. Returns the exit code.
int write_sweep_outputs(sweeps::SweepFolder const& folder, sweeps::Manifest const& manifest,
                        sweeps::Results const& results);

}  // namespace faster
