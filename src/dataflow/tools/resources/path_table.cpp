#include "dataflow/tools/resources/path_table.hpp"

#include <algorithm>
#include <sstream>

#include "dataflow/tools/resources/unit_keys.hpp"

namespace dataflow {

PathTable::PathTable(std::string_view csv) {
    std::istringstream lines{std::string(csv)};
    std::string line;
    std::getline(lines, line);
    std::map<std::string, std::size_t> columns;
    for (std::string const& name : csv_cells(line))
        columns.emplace(name, columns.size());
    while (std::getline(lines, line)) {
        std::vector<std::string> const cells = csv_cells(line);
        auto const cell = [&](char const* name) { return cells.at(columns.at(name)); };
        auto const number = [&](char const* name) { return std::stod(cell(name)); };
        rows_.push_back({cell("unit"),
                         unit_keys(cell("configuration")),
                         {cell("from"),
                          cell("to"),
                          static_cast<unsigned>(number("stages")),
                          {number("low_ns"), number("typical_ns"), number("high_ns")}}});
    }
}

std::vector<UnitPath> PathTable::paths(std::string const& unit, std::map<std::string, std::string> const& keys) const {
    std::size_t most = 0;
    std::vector<UnitPath> paths;
    for (Row const& row : rows_) {
        if (row.unit != unit || row.keys.size() < most ||
            !std::includes(keys.begin(), keys.end(), row.keys.begin(), row.keys.end()))
            continue;
        if (row.keys.size() > most)
            paths.clear();
        most = row.keys.size();
        paths.push_back(row.path);
    }
    return paths;
}

}  // namespace dataflow
