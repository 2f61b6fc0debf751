#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dataflow::io {

/// One column a table must have, and the integers its cells may hold.
struct CsvColumn {
    std::string name;
    std::int64_t min = 0;
    std::int64_t max = 0;
};

/// Called per row with the line number in the file (the header is line 1) and one value per requested column, in the
/// order of the request.
using CsvRowReader = std::function<void(std::size_t line, std::int64_t const* values)>;

/// A table as read_csv_cells() reads it, all of whose requested cells are integers. Throws InputError (file:line) for
/// what that refuses, and for a cell that is not an integer within its column's range.
void read_csv_integers(std::filesystem::path const& path, std::vector<CsvColumn> const& columns,
                       CsvRowReader const& read_row);

}  // namespace dataflow::io
