#pragma once
#include <string>
#include <vector>

namespace dataflow {

/// A design that `accelerator.architecture` names: what a file of configs/architectures says.
struct Preset {
    std::string name;  ///< the file's, without .yaml
    std::string text;  ///< YAML
};

/// Names of the design's presets; the one that all others are compared with first, which has the design's own name.
std::vector<std::string> preset_names();

/// Where messages say that a preset's keys stand.
inline std::string place_of_preset(std::string const& name) { return "configs/architectures/" + name + ".yaml"; }

}  // namespace dataflow
