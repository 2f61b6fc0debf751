#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace faster::experiments {

/// How far off the boxes of a first stage are (docs/poses.md). Shares of the box's sides, and probabilities.
struct DetectorModel {
    double shift = 0;    ///< deviation of the middle, per axis
    double scale = 0;    ///< deviation of the logarithm of each side
    double missing = 0;  ///< that it sees nothing of the object
    double wrong = 0;    ///< that it takes something else for the object, besides
};

/// Scenes of one kind: made, or a dataset that is there.
struct Setting {
    std::string name;
    std::filesystem::path dataset;            ///< empty: scenes are made
    std::filesystem::path models;             ///< meshes of made scenes; empty: the built-in ones
    std::vector<std::string> objects;         ///< classes to look for, each in images of its own
    int images = 0;                           ///< per class
    std::array<double, 2> visible{0.3, 0.9};  ///< share of the object that is to be seen, drawn between these
    DetectorModel boxes;
};

/// One way to score.
struct Method {
    std::string name;
    std::vector<std::string> settings;  ///< "KEY=VALUE"
};

/// An experiment file (docs/formats.md): every method looks for every object of every setting.
struct Experiment {
    std::string file;
    std::filesystem::path base;         ///< configuration; empty: the defaults
    std::vector<std::string> settings;  ///< "KEY=VALUE" for all methods
    std::uint64_t seed = 1;             ///< of scenes and boxes
    std::vector<Setting> scenes;
    std::vector<Method> methods;
};

/// Reads an experiment file (YAML; docs/formats.md). Paths in it are relative to its folder. Throws InputError: the
/// first fault, with file and line, and how many more there are.
Experiment read_experiment_file(std::filesystem::path const& path);

}  // namespace faster::experiments
