#pragma once
#include "dataflow/base/json.hpp"
#include "dataflow/run/figures/column_values.hpp"
#include "dataflow/run/figures/module_row.hpp"

namespace dataflow::report {

/// A row of a table as a JSON object.
template <class Row, std::size_t N> Json json_row(Columns<Row, N> columns, Row const& row) {
    Json object;
    for (Column<Row> const& column : columns)
        object[column.name] = with_value(column, row, [](auto const& value) { return Json(value); });
    return object;
}
Json json_row(ModuleRow const& module);

/// A table as a JSON array.
template <class Row, std::size_t N> Json json_table(Columns<Row, N> columns, std::vector<Row> const& rows) {
    Json array = Json::array();
    for (Row const& row : rows)
        array.push_back(json_row(columns, row));
    return array;
}

}  // namespace dataflow::report
