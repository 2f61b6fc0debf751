#include "dataflow/base/files/csv_integers.hpp"

#include <charconv>
#include <fmt/format.h>
#include <string_view>

#include "dataflow/base/files/csv_cells.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"

namespace dataflow::io {
namespace {

std::vector<std::string> names_of(std::vector<CsvColumn> const& columns) {
    std::vector<std::string> names;
    names.reserve(columns.size());
    for (auto const& column : columns) {
        names.push_back(column.name);
    }
    return names;
}

bool parse(std::string_view cell, std::int64_t& value) {
    auto const result = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return result.ec == std::errc{} && result.ptr == cell.data() + cell.size();
}

}  // namespace

void read_csv_integers(std::filesystem::path const& path, std::vector<CsvColumn> const& columns,
                       CsvRowReader const& read_row) {
    std::vector<std::int64_t> values(columns.size());
    read_csv_cells(path, names_of(columns), [&](std::size_t line, std::string_view const* cells) {
        for (std::size_t i = 0; i < columns.size(); ++i) {
            auto const& [name, min, max] = columns[i];
            if (!parse(cells[i], values[i]) || values[i] < min || values[i] > max) {
                throw InputError(fmt::format("{}:{}: column {} = {}, expected an integer in {}..{}", path.string(),
                                             line, name, cells[i].empty() ? "nothing" : shortened(cells[i]), min, max));
            }
        }
        read_row(line, values.data());
    });
}

}  // namespace dataflow::io
