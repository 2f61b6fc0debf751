#pragma once
#include <map>
#include <string>
#include <vector>

namespace dataflow {

/// A cell of a table's column `configuration`: `default`, or KEY=VALUE parted by blanks. Errors: std::invalid_argument.
std::map<std::string, std::string> unit_keys(std::string const& configuration);
std::vector<std::string> csv_cells(std::string const& line);

}  // namespace dataflow
