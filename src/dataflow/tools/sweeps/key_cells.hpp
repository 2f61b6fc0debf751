#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <yaml-cpp/yaml.h>

#include "dataflow/run/config/key_faults.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/tools/sweeps/sweep.hpp"

namespace dataflow::sweeps {

/// Makes cells of the values of a sweep file. What is wrong with them is added to the faults, and there is no cell.
class KeyCells {
  public:
    /// Paths in the file are relative to `folder`.
    KeyCells(std::filesystem::path folder, KeyFaults& faults) : folder_(std::move(folder)), faults_(faults) {}

    /// The key of that name; null if there is none.
    Key const* key(std::string const& name, int line) const;
    std::optional<Cell> cell(Key const& key, YAML::Node const& value, int line) const;
    /// For values that were worked out.
    static Cell cell(Key const& key, KeyValue const& value);
    /// A path of a file, relative to the current folder.
    std::optional<std::filesystem::path> path(std::string const& name, YAML::Node const& value, int line) const;
    KeyFaults& faults() const { return faults_; }

  private:
    std::filesystem::path folder_;
    KeyFaults& faults_;
};

}  // namespace dataflow::sweeps
