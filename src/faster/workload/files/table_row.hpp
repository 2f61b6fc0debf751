#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::files {

/// Columns of a file of results of BOP, in which the line of names may be missing.
std::vector<std::string> const& columns_of_results();

/// One row of a table with poses in it, as read_csv_cells() gives it, and how to complain about it. Columns are numbers
/// of those that were asked for. Everything throws InputError (file:line: column ... = ..., expected ...).
class TableRow {
  public:
    TableRow(std::filesystem::path const& path, std::vector<std::string> const& columns, std::size_t line,
             std::string_view const* cells)
        : path_(path), columns_(columns), line_(line), cells_(cells) {}

    int id(std::size_t column) const;
    double number(std::size_t column) const;
    /// So many of them, parted by blanks.
    std::vector<double> numbers(std::size_t column, std::size_t count) const;
    /// Of nine numbers, row by row.
    Eigen::Matrix3d rotation(std::size_t column) const;
    /// The complaint that throwing would make.
    std::string complaint(std::size_t column, std::string const& expected) const;
    /// Of three numbers.
    Eigen::Vector3d vector(std::size_t column) const;
    [[noreturn]] void fail(std::size_t column, std::string const& expected) const;

  private:
    std::filesystem::path const& path_;
    std::vector<std::string> const& columns_;
    std::size_t line_;
    std::string_view const* cells_;
};

}  // namespace faster::files
