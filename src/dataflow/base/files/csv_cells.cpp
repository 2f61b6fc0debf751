#include "dataflow/base/files/csv_cells.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/text_lines.hpp"

namespace dataflow::io {
namespace {

/// Takes the text up to `separator` off the front of `rest`, and the separator with it.
std::string_view take_until(std::string_view& rest, char separator) {
    auto const end = rest.find(separator);
    std::string_view const taken = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    return taken;
}

bool begins_with_number(std::string_view text) {
    std::string_view const digits = text.substr(text.substr(0, 1) == "+" ? 1 : 0);
    return !digits.empty() && digits.front() >= '0' && digits.front() <= '9';
}

std::size_t cell_count(std::string_view line) {
    return trimmed(line).empty() ? 0 : static_cast<std::size_t>(std::count(line.begin(), line.end(), ',')) + 1;
}

std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    std::size_t const count = cell_count(line);
    while (cells.size() < count) {
        cells.emplace_back(trimmed(take_until(line, ',')));
    }
    return cells;
}

/// The state of one pass over a table.
class Table {
  public:
    Table(std::filesystem::path const& path, std::vector<std::string> const& columns)
        : path_(path.string()), columns_(columns), cells_(columns.size()) {}

    void read(std::string_view text, CsvCellReader const& read_row) {
        text = without_byte_order_mark(text);
        text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
        line_ = 1;
        read_header(take_until(text, '\n'));
        read_rows(text, read_row);
    }

    void read_below(std::vector<std::string> const& header, std::string_view text, CsvCellReader const& read_row) {
        text = text.substr(0, text.find_last_not_of(" \t\r\n") + 1);
        read_header(fmt::format("{}", fmt::join(header, ",")));
        read_rows(text, read_row);
    }

  private:
    void read_rows(std::string_view text, CsvCellReader const& read_row) {
        while (!text.empty()) {
            ++line_;
            split_row(take_until(text, '\n'));
            read_row(line_, cells_.data());
        }
    }

    static constexpr std::size_t most_columns = 10'000;
    static constexpr std::size_t skipped = static_cast<std::size_t>(-1);

    void read_header(std::string_view line) {
        if (cell_count(line) > most_columns)
            fail(fmt::format("{} columns, expected at most {}", cell_count(line), most_columns));
        std::vector<std::string> const names = cells_of(line);
        column_of_cell_.assign(names.size(), skipped);
        for (std::size_t column = 0; column < columns_.size(); ++column) {
            auto const found = std::find(names.begin(), names.end(), columns_[column]);
            if (found == names.end()) {
                fail(
                    fmt::format("no column {} in the header, expected {}", columns_[column], fmt::join(columns_, ",")));
            }
            if (std::find(found + 1, names.end(), columns_[column]) != names.end()) {
                fail(fmt::format("column {} stands twice in the header, expected once", columns_[column]));
            }
            column_of_cell_[static_cast<std::size_t>(found - names.begin())] = column;
        }
    }

    void split_row(std::string_view line) {
        std::size_t const count = cell_count(line);
        if (count != column_of_cell_.size()) {
            fail(fmt::format("{} cells, expected {} as in the header", count, column_of_cell_.size()));
        }
        for (std::size_t const column : column_of_cell_) {
            std::string_view const cell = take_until(line, ',');
            if (column != skipped) {
                cells_[column] = trimmed(cell);
            }
        }
    }

    [[noreturn]] void fail(std::string const& what) const {
        throw InputError(fmt::format("{}:{}: {}", path_, line_, what));
    }

    std::string path_;
    std::vector<std::string> const& columns_;
    std::size_t line_ = 0;
    std::vector<std::size_t> column_of_cell_;  // per cell of a row, the requested column or skipped
    std::vector<std::string_view> cells_;      // per requested column
};

}  // namespace

void read_csv_cells(std::filesystem::path const& path, std::vector<std::string> const& columns,
                    CsvCellReader const& read_row) {
    std::string const text = read_file(path);
    Table(path, columns).read(text, read_row);
}

void read_csv_cells_of(std::filesystem::path const& path, std::vector<std::string> const& header,
                       std::vector<std::string> const& columns, CsvCellReader const& read_row) {
    std::string const text = read_file(path);
    std::string_view const content = without_byte_order_mark(text);
    if (begins_with_number(content))
        Table(path, columns).read_below(header, content, read_row);
    else
        Table(path, columns).read(content, read_row);
}

bool is_row_first(std::filesystem::path const& path) {
    return begins_with_number(without_byte_order_mark(read_file(path)));
}

bool has_csv_column(std::filesystem::path const& path, std::string const& column) {
    std::string const text = read_file(path);
    std::string_view rest = without_byte_order_mark(text);
    std::vector<std::string> const names = cells_of(take_until(rest, '\n'));
    return std::find(names.begin(), names.end(), column) != names.end();
}

}  // namespace dataflow::io
