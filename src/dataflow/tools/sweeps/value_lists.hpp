#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/run/config/value_reader.hpp"
#include "dataflow/tools/sweeps/key_cells.hpp"

namespace dataflow::sweeps {

/// Reads lists and numbers of a sweep file. What is wrong with them is added to the faults.
class ValueLists {
  public:
    explicit ValueLists(KeyCells const& cells) : cells_(cells) {}

    KeyCells const& cells() const { return cells_; }
    void fault(int line, std::string const& key, std::string const& problem) const;
    void reject(MapEntry const& entry, std::string const& expected) const;

    /// The cells of a list of values of `key`, none twice if `distinct`.
    std::vector<Cell> cells_of(Key const& key, MapEntry const& list, bool distinct) const;
    /// [LOW, HIGH], both valid values of `key`.
    std::optional<std::pair<double, double>> bounds(Key const& key, MapEntry const& entry) const;
    std::optional<std::int64_t> whole_number(MapEntry const& entry, std::int64_t least, std::int64_t most) const;

  private:
    std::optional<double> number(Key const& key, YAML::Node const& node, int line) const;

    KeyCells const& cells_;
};

}  // namespace dataflow::sweeps
