#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>
#include <yaml-cpp/yaml.h>

#include "dataflow/run/config/key.hpp"
#include "dataflow/run/config/key_faults.hpp"

namespace dataflow {

/// The value of `key` as `node` has it. Whatever is wrong with it is added to `faults`, with `line` for where no better
/// one is known, and there is no value then. Relative paths are taken to be relative to `folder`.
std::optional<KeyValue> read_value(Key const& key, YAML::Node const& node, int line,
                                   std::filesystem::path const& folder, KeyFaults& faults);

/// A map's entries in their order. An entry whose key is no single word, or repeats an earlier one, is added to
/// `faults` and left out. `prefix` ("accelerator.") leads to the map.
struct MapEntry {
    std::string name;
    int line = 0;
    YAML::Node value;
};
std::vector<MapEntry> read_entries(YAML::Node const& map, std::string const& prefix, KeyFaults& faults);

/// How a message shows a value.
std::string shown(YAML::Node const& node);

}  // namespace dataflow
