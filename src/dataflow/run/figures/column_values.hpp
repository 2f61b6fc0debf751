#pragma once
#include <algorithm>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "dataflow/base/column.hpp"

namespace dataflow {

/// A table, as in table_columns.hpp.
template <class Row, std::size_t N> using Columns = Column<Row> const (&)[N];

/// Calls `use` with what a row has in a column: a number or a text.
template <class Row, class Use> auto with_value(Column<Row> const& column, Row const& row, Use const& use) {
    return std::visit([&](auto const member) { return use(std::invoke(member, row)); }, column.member);
}

/// The figure in a column; none if it has texts or fractions.
template <class Row> std::optional<std::uint64_t> figure_in(Column<Row> const& column, Row const& row) {
    return with_value(column, row, [](auto const& value) -> std::optional<std::uint64_t> {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::uint64_t>)
            return value;
        else
            return std::nullopt;
    });
}

/// What a row has in a column, as a cell of a CSV file.
inline std::string cell_of(std::string const& text) { return text; }
template <class Number> std::string cell_of(Number number) { return std::to_string(number); }
template <class Row> std::string cell_in(Column<Row> const& column, Row const& row) {
    return with_value(column, row, [](auto const& value) { return cell_of(value); });
}

/// A table's columns and a row's cells in a CSV file.
template <class Row, std::size_t N> std::vector<std::string> csv_header(Columns<Row, N> columns) {
    std::vector<std::string> names;
    for (Column<Row> const& column : columns)
        if (column.is_in_csv())
            names.emplace_back(column.name);
    return names;
}
template <class Row, std::size_t N> std::vector<std::string> csv_cells(Columns<Row, N> columns, Row const& row) {
    std::vector<std::string> cells;
    for (Column<Row> const& column : columns)
        if (column.is_in_csv())
            cells.push_back(cell_in(column, row));
    return cells;
}

/// Where a column's value is stored: a std::uint64_t or a std::string. Null if it is of another type, or follows from
/// other columns.
template <class Value, class Row> Value const* place_of(Column<Row> const& column, Row const& row) {
    auto const* const member = std::get_if<Value Row::*>(&column.member);
    return member == nullptr ? nullptr : &(row.**member);
}
template <class Value, class Row> Value* place_of(Column<Row> const& column, Row& row) {
    return const_cast<Value*>(place_of<Value>(column, std::as_const(row)));
}

/// Puts the same item of another core to what is known of it.
template <class Row, std::size_t N> void add_core(Columns<Row, N> columns, Row& sum, Row const& row) {
    for (Column<Row> const& column : columns)
        if (auto* const place = place_of<std::uint64_t>(column, sum); place != nullptr && column.tells != Tells::key) {
            std::uint64_t const figure = *figure_in(column, row);
            *place = column.is_summed() ? *place + figure : std::max(*place, figure);
        }
}

/// One row for all cores together per name, in the order in which the names come.
template <class Row, std::size_t N> std::vector<Row> over_cores(Columns<Row, N> columns, std::vector<Row> const& rows) {
    std::vector<Row> sums;
    std::map<std::string, std::size_t> index;
    for (Row const& row : rows) {
        auto const [found, is_new] = index.try_emplace(row.name(), sums.size());
        if (is_new)
            sums.push_back(row);
        else
            add_core(columns, sums[found->second], row);
    }
    return sums;
}

}  // namespace dataflow
