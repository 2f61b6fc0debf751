#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "dataflow/run/config/load_config.hpp"

namespace dataflow {

/// The steps of load_config. Each returns its complaints, ready to print, and applies what is sound.

/// `name`: one of preset_names().
std::vector<std::string> apply_preset(std::string const& name, LoadedConfig& loaded);

/// Throws InputError if there is no YAML document to read from.
std::vector<std::string> apply_file(std::filesystem::path const& path, LoadedConfig& loaded);

/// `setting` is "a.b.c=value".
std::vector<std::string> apply_override(std::string const& setting, LoadedConfig& loaded);

/// What no key can say on its own: machine_complaints(), Design::complaints(), and keys of parts that are not there.
std::vector<std::string> cross_check(LoadedConfig const& loaded);

/// Part of cross_check(): what contradicts itself in any machine.
std::vector<std::string> machine_complaints(LoadedConfig const& loaded);

/// "KEY = 3", with "(default)" behind it unless it was asked for.
std::string with_value(LoadedConfig const& loaded, std::string const& key);

/// "PLACE: KEY = VALUE, expected ..." for the value a key has now.
std::string complaint(LoadedConfig const& loaded, std::string const& key, std::string const& expected);

}  // namespace dataflow
