#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace faster::io {

/// One column a table must have, and the integers its cells may hold.
struct CsvColumn {
    std::string name;
    std::int64_t min = 0;
    std::int64_t max = 0;
};

/// Called per row with the line number in the file (the header is line 1) and one value per requested column, in the
/// order of the request.
using CsvRowReader = std::function<void(std::size_t line, std::int64_t const* values)>;

/// Reads a comma-separated table of integers whose first line names the columns. Columns are found by name: they may
/// stand in any order, and others beside them are skipped unread. LF and CRLF, blanks around cells, a byte-order mark
/// and empty lines at the end are fine. Throws InputError (file:line) for a missing or repeated column, a row with more
/// or fewer cells than the header, and a cell that is not an integer within its column's range.
void read_csv_integers(std::filesystem::path const& path, std::vector<CsvColumn> const& columns,
                       CsvRowReader const& read_row);

}  // namespace faster::io
