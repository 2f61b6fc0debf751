#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace dataflow::io {

/// Called per row with the line number in the file (the header is line 1) and one cell per requested column, in the
/// order of the request and without the blanks around it. The cells are valid until the call returns.
using CsvCellReader = std::function<void(std::size_t line, std::string_view const* cells)>;

/// Reads a comma-separated table whose first line names the columns; what a cell may hold is up to the caller. Columns
/// are found by name: they may stand in any order, and others beside them are skipped unread. LF and CRLF, blanks
/// around cells, a byte-order mark and empty lines at the end are fine; quotes mean nothing. Throws InputError
/// (file:line) for a missing or repeated column, and a row with more or fewer cells than the header.
void read_csv_cells(std::filesystem::path const& path, std::vector<std::string> const& columns,
                    CsvCellReader const& read_row);

/// Reads a table whose first line may be missing, as above: if is_row_first(), the columns of the table are those of
/// `header`, in that order.
void read_csv_cells_of(std::filesystem::path const& path, std::vector<std::string> const& header,
                       std::vector<std::string> const& columns, CsvCellReader const& read_row);

/// Whether a table begins with a number, so that its first line is a row.
bool is_row_first(std::filesystem::path const& path);

/// Whether the first line of a table names that column.
bool has_csv_column(std::filesystem::path const& path, std::string const& column);

}  // namespace dataflow::io
