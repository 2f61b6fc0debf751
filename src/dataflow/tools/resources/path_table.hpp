#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/base/device/unit_path.hpp"

namespace dataflow {

/// Longest paths of synthesized configurations of units: rtl/timing.csv, of which the columns unit, configuration,
/// stages, low_ns, typical_ns, high_ns, from and to count.
class PathTable {
  public:
    /// Errors: std::invalid_argument, std::out_of_range for a table without these columns.
    explicit PathTable(std::string_view csv);

    /// The paths of the row that has most of a configuration's keys and no other; none for a unit that is not there.
    std::vector<UnitPath> paths(std::string const& unit, std::map<std::string, std::string> const& keys) const;

  private:
    struct Row {
        std::string unit;
        std::map<std::string, std::string> keys;
        UnitPath path;
    };
    std::vector<Row> rows_;
};

}  // namespace dataflow
