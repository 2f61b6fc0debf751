#include "kernel/compare/table_files.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "kernel/base/files/csv_cells.hpp"
#include "kernel/base/files/csv_integers.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/compare/json_section.hpp"
#include "kernel/config/design.hpp"
#include "kernel/figures/column_values.hpp"

namespace faster::runs {

namespace {

namespace fs = std::filesystem;
using Texts = std::vector<std::string>;

[[noreturn]] void fail(fs::path const& path, std::size_t line, std::string const& what) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), line, what));
}

[[noreturn]] void fail_rows(fs::path const& path, std::size_t rows, std::string const& expected) {
    throw InputError(fmt::format("{}: {} rows, expected {}", path.string(), rows, expected));
}

/// What the cells of a column of samples may be. A sample takes a cycle at least, and lies within the run.
io::CsvColumn limits_of(ColumnFacts const& column, RunRecord const& run) {
    std::string const name = column.name;
    std::int64_t const min = name == "latency_cycles" ? 1 : 0;
    auto const cycles = static_cast<std::int64_t>(run.total_cycles);
    if (name == "core")
        return {name, min, static_cast<std::int64_t>(run.raster_cores) - 1};
    if (column.is_in_cycles())
        return {name, min, std::string_view(column.unit) == "cycle" ? cycles - 1 : cycles};
    return {name, min, static_cast<std::int64_t>(largest_figure)};
}

std::vector<io::CsvColumn> limits_of_samples(RunRecord const& run) {
    std::vector<io::CsvColumn> limits;
    for (ColumnFacts const& column : sample_columns)
        limits.push_back(limits_of(column, run));
    for (ColumnFacts const& counter : design().counters())
        limits.push_back(limits_of(counter, run));
    return limits;
}

SampleStatistics sample_of(std::int64_t const* values) {
    SampleStatistics sample;
    for (auto const& column : sample_columns) {
        if (auto* const place = place_of<std::uint64_t>(column, sample))
            *place = static_cast<std::uint64_t>(*values);
        ++values;
    }
    for (std::size_t i = design().counters().size(); i > 0; --i)
        sample.counters.push_back(static_cast<std::uint64_t>(*values++));
    return sample;
}

/// The latency follows from other columns.
void check_latency(fs::path const& path, std::size_t line, std::int64_t const* values, SampleStatistics const& sample) {
    for (auto const& column : sample_columns) {
        auto const follows = static_cast<std::int64_t>(*figure_in(column, sample));
        if (*values != follows)
            fail(path, line,
                 fmt::format("column {} = {}, expected end_cycle + 1 - start_cycle = {}", column.name, *values,
                             follows));
        ++values;
    }
}

/// Rows of the summary that are looked for, by their keys.
class ExpectedRows {
  public:
    template <class Row, std::size_t N>
    ExpectedRows(Columns<Row, N> columns, std::vector<Row> const& rows) : columns_(csv_header(columns)) {
        for (Column<Row> const& column : columns)
            keys_ += column.tells == Tells::key ? 1U : 0U;
        for (Row const& row : rows) {
            Texts const cells = csv_cells(columns, row);
            rows_[key_of(cells.data())] = cells;
        }
    }

    /// How many rows a file has of each core. Throws InputError if one says something else than the summary.
    std::map<std::string, std::size_t> check(fs::path const& path) const {
        std::map<std::string, std::size_t> rows_of_core;
        std::set<std::string> seen;
        io::read_csv_cells(path, columns_, [&](std::size_t line, std::string_view const* cells) {
            std::string const key = key_of(cells);
            check_row(path, line, cells, key);
            if (!seen.insert(key).second)
                fail(path, line, fmt::format("a second row for {}, expected one", key));
            ++rows_of_core[std::string(cells[0])];
        });
        return rows_of_core;
    }

  private:
    /// "core 0, fifo command"
    template <class Text> std::string key_of(Text const* cells) const {
        std::string key;
        for (std::size_t i = 0; i < keys_; ++i)
            key += fmt::format("{}{} {}", i == 0 ? "" : ", ", columns_[i], cells[i]);
        return key;
    }

    void check_row(fs::path const& path, std::size_t line, std::string_view const* cells,
                   std::string const& key) const {
        auto const row = rows_.find(key);
        if (row == rows_.end())
            fail(path, line, fmt::format("a row for {}, expected one that summary.json has as well", key));
        for (std::size_t i = keys_; i < columns_.size(); ++i)
            if (cells[i] != row->second[i])
                fail(path, line,
                     fmt::format("column {} = {}, expected {} as in summary.json", columns_[i],
                                 cells[i].empty() ? "nothing" : cells[i],
                                 row->second[i].empty() ? "nothing" : row->second[i]));
    }

    Texts columns_;
    std::size_t keys_ = 0;  ///< the first columns, which say which row it is
    std::map<std::string, Texts> rows_;
};

}  // namespace

std::vector<SampleStatistics> read_samples(fs::path const& path, RunRecord const& run, std::uint64_t samples) {
    std::vector<SampleStatistics> records;
    io::read_csv_integers(path, limits_of_samples(run), [&](std::size_t line, std::int64_t const* values) {
        SampleStatistics const record = sample_of(values);
        if (record.sample != records.size())
            fail(path, line,
                 fmt::format("column sample = {}, expected {} (numbered from 0 without gaps)", record.sample,
                             records.size()));
        check_latency(path, line, values, record);
        records.push_back(record);
    });
    if (records.size() != samples)
        fail_rows(path, records.size(), fmt::format("{}, the samples of summary.json", samples));
    return records;
}

void check_fifos(fs::path const& path, RunRecord const& run) {
    std::size_t rows = 0;
    for (auto const& core : ExpectedRows(fifo_columns, run.fifos).check(path))
        rows += core.second;
    if (rows != run.fifos.size())
        fail_rows(path, rows, fmt::format("{}, the FIFOs of summary.json", run.fifos.size()));
}

void check_loops(fs::path const& path, RunRecord const& run) {
    auto const rows_of_core = ExpectedRows(loop_columns, run.loops).check(path);
    std::size_t rows = 0;
    std::size_t most = 1;
    for (auto const& core : rows_of_core) {
        rows += core.second;
        most = std::max(most, core.second);
    }
    if (rows != most * run.raster_cores)
        fail_rows(
            path, rows,
            fmt::format("{}, as many for each of the {} {}", most * run.raster_cores, run.raster_cores, cores_are()));
}

}  // namespace faster::runs
