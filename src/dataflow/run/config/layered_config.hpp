#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"

namespace dataflow {

/// load_config() of several files: a later one wins over an earlier one, `overrides` win over all. No file: defaults
/// and preset.
LoadedConfig layered_config(std::vector<std::filesystem::path> const& files, std::vector<std::string> const& overrides);

}  // namespace dataflow
