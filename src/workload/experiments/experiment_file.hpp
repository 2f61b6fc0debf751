#pragma once
#include "workload/experiments/experiment.hpp"

namespace faster::experiments {

/// Reads an experiment file (YAML; docs/formats.md). Paths in it are relative to its folder. Throws InputError: the
/// first fault, with file and line, and how many more there are.
Experiment read_experiment_file(std::filesystem::path const& path);

}  // namespace faster::experiments
