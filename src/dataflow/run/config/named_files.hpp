#pragma once
#include <filesystem>
#include <vector>

#include "kernel/config/run_config.hpp"

namespace faster {

/// The files and folders that a configuration names: a folder is followed by Design::files_of() it, unless it cannot be
/// read.
std::vector<std::filesystem::path> named_files(RunConfig const& config);

}  // namespace faster
