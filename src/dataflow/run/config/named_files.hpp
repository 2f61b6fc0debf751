#pragma once
#include <filesystem>
#include <vector>

#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// The files and folders that a configuration names: a folder is followed by Design::files_of() it, unless it cannot be
/// read.
std::vector<std::filesystem::path> named_files(RunConfig const& config);

}  // namespace dataflow
