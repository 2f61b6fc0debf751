#pragma once
#include <string>
#include <vector>

namespace faster {

/// A design that `accelerator.architecture` names: what a file of configs/architectures says.
struct Preset {
    std::string name;  ///< the file's, without .yaml
    std::string text;  ///< YAML
};

/// All of them, by name.
std::vector<Preset> const& presets();

/// "faster", which all others are compared with, before the rest.
std::vector<std::string> preset_names();

/// Where messages say that a preset's keys stand.
inline std::string place_of_preset(std::string const& name) { return "configs/architectures/" + name + ".yaml"; }

}  // namespace faster
