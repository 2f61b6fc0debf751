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

std::vector<io::CsvColumn> sample_columns(RunRecord const& run) {
    auto const last_core = static_cast<std::int64_t>(run.raster_cores) - 1;
    auto const cycles = static_cast<std::int64_t>(run.total_cycles);
    auto const most = static_cast<std::int64_t>(largest_figure);
    return {{"sample", 0, most},          {"core", 0, last_core},        {"start_cycle", 0, cycles - 1},
            {"end_cycle", 0, cycles - 1}, {"latency_cycles", 1, cycles}, {"valid_raster", 0, most},
            {"valid_depth", 0, most},     {"inlier", 0, most},           {"valid_edge", 0, most},
            {"edge_inlier", 0, most}};
}

std::vector<std::uint64_t> unsigned_values(std::int64_t const* values, std::size_t count) {
    return {values, values + count};
}

/// Where the columns of a table of the summary are repeated: the first `keys` of them say which row it is.
struct Repeated {
    Texts columns;
    std::size_t keys = 0;
};

Repeated const fifo_table{{"core", "fifo", "kind", "depth", "write_latency", "writes", "reads", "full_stall_cycles",
                           "empty_stall_cycles", "max_occupancy"},
                          2};

Texts cells_of(FifoRecord const& f) {
    return {std::to_string(f.core),
            f.fifo,
            f.kind,
            std::to_string(f.depth),
            std::to_string(f.write_latency),
            std::to_string(f.writes),
            std::to_string(f.reads),
            std::to_string(f.full_stall_cycles),
            std::to_string(f.empty_stall_cycles),
            std::to_string(f.max_occupancy)};
}

Repeated const loop_table{{"core", "module", "loop", "ii_target", "ii_recurrence", "ii", "depth", "entries",
                           "iterations", "port_conflict_cycles", "recurrence_cycles", "limited_by"},
                          3};

Texts cells_of(LoopRecord const& l) {
    return {std::to_string(l.core),
            l.module,
            l.loop,
            std::to_string(l.ii_target),
            std::to_string(l.ii_recurrence),
            std::to_string(l.ii),
            std::to_string(l.depth),
            std::to_string(l.entries),
            std::to_string(l.iterations),
            std::to_string(l.port_conflict_cycles),
            std::to_string(l.recurrence_cycles),
            l.limited_by};
}

/// Rows of the summary that are looked for, by their keys.
class ExpectedRows {
  public:
    template <class Record> ExpectedRows(Repeated const& table, std::vector<Record> const& records) : table_(table) {
        for (Record const& record : records) {
            Texts const cells = cells_of(record);
            rows_[key_of(cells.data())] = cells;
        }
    }

    /// How many rows a file has of each core. Throws InputError if one says something else than the summary.
    std::map<std::string, std::size_t> check(fs::path const& path) const {
        std::map<std::string, std::size_t> rows_of_core;
        std::set<std::string> seen;
        io::read_csv_cells(path, table_.columns, [&](std::size_t line, std::string_view const* cells) {
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
        for (std::size_t i = 0; i < table_.keys; ++i)
            key += fmt::format("{}{} {}", i == 0 ? "" : ", ", table_.columns[i], cells[i]);
        return key;
    }

    void check_row(fs::path const& path, std::size_t line, std::string_view const* cells,
                   std::string const& key) const {
        auto const row = rows_.find(key);
        if (row == rows_.end())
            fail(path, line, fmt::format("a row for {}, expected one that summary.json has as well", key));
        for (std::size_t i = table_.keys; i < table_.columns.size(); ++i)
            if (cells[i] != row->second[i])
                fail(path, line,
                     fmt::format("column {} = {}, expected {} as in summary.json", table_.columns[i],
                                 cells[i].empty() ? "nothing" : cells[i],
                                 row->second[i].empty() ? "nothing" : row->second[i]));
    }

    Repeated const& table_;
    std::map<std::string, Texts> rows_;
};

}  // namespace

std::vector<SampleRecord> read_samples(fs::path const& path, RunRecord const& run, std::uint64_t samples) {
    std::vector<SampleRecord> records;
    std::vector<io::CsvColumn> const columns = sample_columns(run);
    io::read_csv_integers(path, columns, [&](std::size_t line, std::int64_t const* values) {
        auto const v = unsigned_values(values, columns.size());
        SampleRecord const record{v[1], v[2], v[3], {v[5], v[6], v[7], v[8], v[9]}};
        if (v[0] != records.size())
            fail(path, line,
                 fmt::format("column sample = {}, expected {} (numbered from 0 without gaps)", v[0], records.size()));
        if (v[4] != record.latency_cycles())
            fail(path, line,
                 fmt::format("column latency_cycles = {}, expected end_cycle + 1 - start_cycle = {}", v[4],
                             values[3] + 1 - values[2]));
        records.push_back(record);
    });
    if (records.size() != samples)
        fail_rows(path, records.size(), fmt::format("{}, the samples of summary.json", samples));
    return records;
}

void check_fifos(fs::path const& path, RunRecord const& run) {
    std::size_t rows = 0;
    for (auto const& core : ExpectedRows(fifo_table, run.fifos).check(path))
        rows += core.second;
    if (rows != run.fifos.size())
        fail_rows(path, rows, fmt::format("{}, the FIFOs of summary.json", run.fifos.size()));
}

void check_loops(fs::path const& path, RunRecord const& run) {
    auto const rows_of_core = ExpectedRows(loop_table, run.loops).check(path);
    std::size_t rows = 0;
    std::size_t most = 1;
    for (auto const& core : rows_of_core) {
        rows += core.second;
        most = std::max(most, core.second);
    }
    if (rows != most * run.raster_cores)
        fail_rows(
            path, rows,
            fmt::format("{}, as many for each of the {} raster cores", most * run.raster_cores, run.raster_cores));
}

}  // namespace faster::runs
