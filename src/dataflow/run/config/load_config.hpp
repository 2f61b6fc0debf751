#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dataflow/run/config/run_config.hpp"

namespace dataflow {

/// What gave a key its value, the strongest last.
enum class KeySource { default_value, preset, file, command_line, trace };

struct KeyOrigin {
    KeySource source = KeySource::default_value;
    std::string place;  ///< "FILE:LINE" (of a preset as well), "--set KEY=VALUE" or what was read, e.g. "trace"; empty
                        ///< for a default
};

/// Where every key that does not just have its default was set.
class KeyOrigins {
  public:
    KeyOrigin of(std::string const& key) const {
        auto const found = origins_.find(key);
        return found == origins_.end() ? KeyOrigin{} : found->second;
    }
    bool is_explicit(std::string const& key) const { return of(key).source != KeySource::default_value; }
    void record(std::string const& key, KeyOrigin origin) { origins_[key] = std::move(origin); }
    std::map<std::string, KeyOrigin> const& all() const { return origins_; }

  private:
    std::map<std::string, KeyOrigin> origins_;
};

/// A configuration with every key resolved, and where each came from.
struct LoadedConfig {
    RunConfig config;
    KeyOrigins origins;
};

/// What event files begin with (docs/formats.md#event-files): such a file is no configuration, and no text.
constexpr std::string_view event_file_mark = "FASTEREV";
/// Whether a file does; not of a pipe, whose beginning would be lost.
bool is_event_file(std::filesystem::path const& path);

/// Reads a configuration file (YAML; empty is fine: all defaults) and applies `overrides`, each "a.b.c=value", in their
/// order; they win over the file, later ones over earlier ones. Below both lies the preset that
/// `accelerator.architecture` names. Relative paths in the file are relative to its folder,
/// those in overrides to the current one; all come out relative to the current one.
///
/// Throws InputError on anything wrong: an unknown or repeated key, a value of the wrong type or out of range, values
/// that contradict each other. The message is the first fault, and how many more there are.
LoadedConfig load_config(std::filesystem::path const& path, std::vector<std::string> const& overrides = {});

/// load_config() of several files: a later one wins over an earlier one, `overrides` win over all. No file: defaults
/// and preset.
LoadedConfig layered_config(std::vector<std::filesystem::path> const& files, std::vector<std::string> const& overrides);

/// What a preset alone sets; everything else has its default. `name`: one of preset_names().
LoadedConfig load_preset(std::string const& name);

}  // namespace dataflow
