#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace dataflow {

/// One item of a list of configurations: what it changes.
struct Settings {
    int line = 0;                        ///< in the file, from 1
    std::vector<std::string> overrides;  ///< "a.b.c=value" each
};

/// Reads a YAML list of maps from keys ("a.b.c") to values. What the keys mean is not looked at. Throws InputError for
/// anything else, with `example` for what a map may have: "a.b.c: value".
std::vector<Settings> read_settings_list(std::filesystem::path const& path, std::string const& example);

}  // namespace dataflow
