#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "kernel/config/key_origins.hpp"
#include "kernel/config/run_config.hpp"

namespace faster {

/// A configuration with every key resolved, and where each came from.
struct LoadedConfig {
    RunConfig config;
    KeyOrigins origins;
};

/// Reads a configuration file (YAML; empty is fine: all defaults) and applies `overrides`, each "a.b.c=value", in their
/// order; they win over the file, later ones over earlier ones. Below both lies the preset that
/// `accelerator.architecture` names. Relative paths in the file are relative to its folder,
/// those in overrides to the current one; all come out relative to the current one.
///
/// Throws InputError on anything wrong: an unknown or repeated key, a value of the wrong type or out of range, values
/// that contradict each other. The message is the first fault, and how many more there are.
LoadedConfig load_config(std::filesystem::path const& path, std::vector<std::string> const& overrides = {});

/// What a preset alone sets; everything else has its default. `name`: one of preset_names().
LoadedConfig load_preset(std::string const& name);

}  // namespace faster
