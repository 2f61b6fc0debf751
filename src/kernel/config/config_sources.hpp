#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "kernel/config/load_config.hpp"

namespace faster {

/// The steps of load_config. Each returns its complaints, ready to print, and applies what is sound.

/// `name`: one of presets().
std::vector<std::string> apply_preset(std::string const& name, LoadedConfig& loaded);

/// Throws InputError if there is no YAML document to read from.
std::vector<std::string> apply_file(std::filesystem::path const& path, LoadedConfig& loaded);

/// `setting` is "a.b.c=value".
std::vector<std::string> apply_override(std::string const& setting, LoadedConfig& loaded);

/// What no key can say on its own: see SPEC sections 2 (fraction bits) and 3 (write latencies).
std::vector<std::string> cross_check(LoadedConfig const& loaded);

/// Part of cross_check(): banks need words, and a factor a type.
void check_partition(LoadedConfig const& loaded, BramId bram, std::vector<std::string>& complaints);

/// "KEY = 3", with "(default)" behind it unless it was asked for.
std::string with_value(LoadedConfig const& loaded, std::string const& key);

/// "PLACE: KEY = VALUE, expected ..." for the value a key has now.
std::string complaint(LoadedConfig const& loaded, std::string const& key, std::string const& expected);

}  // namespace faster
