#include "dataflow/tools/compare/read_run.hpp"

#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "dataflow/base/files/csv_cells.hpp"
#include "dataflow/base/files/csv_integers.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/json_node.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/figures/column_values.hpp"

namespace dataflow::runs {

namespace {

namespace fs = std::filesystem;
using io::JsonNode;
using Texts = std::vector<std::string>;

/// The largest figure a run may have: 2^53 - 1, which every JSON reader keeps exactly. A sum over the at most 1024
/// cores fits into 63 bits, so sums and differences do not overflow.
constexpr std::uint64_t largest_figure = (std::uint64_t{1} << 53U) - 1;

[[noreturn]] void fail(fs::path const& path, std::size_t line, std::string const& what) {
    throw InputError(fmt::format("{}:{}: {}", path.string(), line, what));
}

[[noreturn]] void fail_rows(fs::path const& path, std::size_t rows, std::string const& expected) {
    throw InputError(fmt::format("{}: {} rows, expected {}", path.string(), rows, expected));
}

/// What the cells of a column of samples may be. A sample ends within the run, and may begin after its end: the module
/// that begins samples may be the last to be done.
io::CsvColumn limits_of(ColumnFacts const& column, RunRecord const& run) {
    std::string const name = column.name;
    auto const cycles = static_cast<std::int64_t>(run.total_cycles);
    if (name == "core")
        return {name, 0, static_cast<std::int64_t>(run.raster_cores) - 1};
    if (column.is_in_cycles() && name != "start_cycle")
        return {name, 0, name == "end_cycle" ? cycles - 1 : cycles};
    return {name, 0, static_cast<std::int64_t>(largest_figure)};
}

std::string first_line(fs::path const& path) {
    std::ifstream file(path);
    std::string line;
    std::getline(file, line);
    return line;
}

/// How many of the design's counters a samples.csv has, by the length of its first line. Names are checked when it is
/// read.
std::size_t counters_in(fs::path const& path) {
    std::string const header = first_line(path);
    auto const columns = static_cast<std::size_t>(std::count(header.begin(), header.end(), ',')) + 1;
    std::size_t const all = design().counters().size(), always = design().counters_of_all();
    return columns <= std::size(sample_columns) + always ? always : all;
}

/// Another design's samples have other counters. Programs of one design may have several names.
void require_own_design(fs::path const& folder, std::string const& program) {
    std::string const header = first_line(folder / "samples.csv") + ",";
    auto const begin = design().counters().begin();
    bool const is_own = std::all_of(begin, begin + static_cast<std::ptrdiff_t>(design().counters_of_all()),
                                    [&header](ColumnFacts const& counter) {
                                        return header.find(fmt::format(",{},", counter.name)) != header.npos;
                                    });
    if (!is_own && !program.empty() && program != program_name())
        throw InputError(fmt::format("{}: a run of {}, whose design is another one, expected one of {}",
                                     folder.string(), program, program_name()));
}

std::vector<io::CsvColumn> limits_of_samples(RunRecord const& run, std::size_t counters) {
    std::vector<io::CsvColumn> limits;
    for (ColumnFacts const& column : sample_columns)
        limits.push_back(limits_of(column, run));
    for (std::size_t i = 0; i < counters; ++i)
        limits.push_back(limits_of(design().counters()[i], run));
    return limits;
}

SampleStatistics sample_of(std::int64_t const* values, std::size_t counters) {
    SampleStatistics sample;
    for (auto const& column : sample_columns) {
        if (auto* const place = place_of<std::uint64_t>(column, sample))
            *place = static_cast<std::uint64_t>(*values);
        ++values;
    }
    for (std::size_t i = counters; i > 0; --i)
        sample.counters.push_back(static_cast<std::uint64_t>(*values++));
    return sample;
}

/// The latency follows from other columns.
void check_latency(fs::path const& path, std::size_t line, std::int64_t const* values, SampleStatistics const& sample) {
    for (auto const& column : sample_columns) {
        auto const follows = static_cast<std::int64_t>(*figure_in(column, sample));
        if (*values != follows)
            fail(path, line,
                 fmt::format("column {} = {}, expected {}, by start_cycle and end_cycle", column.name, *values,
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

/// The rows of a samples.csv, which must fit the run: numbered without gaps, as many as `samples`, on its cores, and
/// within its cycles. Throws InputError.
std::vector<SampleStatistics> read_samples(fs::path const& path, RunRecord const& run, std::uint64_t samples) {
    std::vector<SampleStatistics> records;
    std::size_t const counters = counters_in(path);
    io::read_csv_integers(path, limits_of_samples(run, counters), [&](std::size_t line, std::int64_t const* values) {
        SampleStatistics const record = sample_of(values, counters);
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

/// fifos.csv, loops.csv and all_loops.csv tell again what stands in the summary. If they tell something else (a file
/// cut off, edited, or of another run), nobody can say which is right: InputError. Loops that loops.csv leaves out for
/// every core are fine.
template <class Row, std::size_t N>
void check_all(fs::path const& path, Columns<Row, N> columns, std::vector<Row> const& expected,
               std::string const& what) {
    std::size_t rows = 0;
    for (auto const& core : ExpectedRows(columns, expected).check(path))
        rows += core.second;
    if (rows != expected.size())
        fail_rows(path, rows, fmt::format("{}, the {} of summary.json", expected.size(), what));
}

void check_loops(fs::path const& path, RunRecord const& run) {
    auto const rows_of_core = ExpectedRows(loop_columns, run.loops).check(path);
    std::size_t rows = 0;
    std::size_t most = run.loops.empty() ? 0 : 1;
    for (auto const& core : rows_of_core) {
        rows += core.second;
        most = std::max(most, core.second);
    }
    if (rows != most * run.raster_cores)
        fail_rows(
            path, rows,
            fmt::format("{}, as many for each of the {} {}", most * run.raster_cores, run.raster_cores, cores_are()));
}

constexpr char const* format = "faster-summary";
constexpr std::uint64_t version = 1;
constexpr std::uint64_t most_cores = 1024;  // as accelerator.raster_cores

std::uint64_t figure(JsonNode const& node) { return node.unsigned_integer(0, largest_figure); }

std::vector<ConfigurationEntry> read_configuration(JsonNode const& configuration) {
    std::vector<ConfigurationEntry> entries;
    for (auto const& [key, entry] : configuration.members())
        entries.push_back({key, entry.at("value").value().dump()});
    return entries;
}

bool is_cycle_class(std::string_view name) {
    constexpr std::string_view ending = "_cycles";
    return name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending;
}

/// Values of another type (a breakdown of a class, say) are for others to read.
std::vector<NamedCycles> read_classes(JsonNode const& row) {
    std::vector<NamedCycles> classes;
    for (auto const& [key, node] : row.members())
        if (is_cycle_class(key) && !node.value().is_structured())
            classes.push_back({key, figure(node)});
    return classes;
}

ModuleRecord read_module(JsonNode const& row, std::uint64_t core) {
    return {core, row.at("module").text(), read_classes(row)};
}

/// A row of the columns that the CSV files have too.
template <class Row, std::size_t N> Row read_row(JsonNode const& cells, Columns<Row, N> columns) {
    Row row;
    for (Column<Row> const& column : columns) {
        if (!column.is_in_csv())
            continue;
        if (auto* const number = place_of<std::uint64_t>(column, row))
            *number = figure(cells.at(column.name));
        if (auto* const text = place_of<std::string>(column, row))
            *text = cells.at(column.name).text();
    }
    return row;
}

FifoRow read_fifo(JsonNode const& row, std::uint64_t) { return read_row(row, fifo_columns); }
LoopRow read_loop(JsonNode const& row, std::uint64_t) { return read_row(row, loop_columns); }

/// Rows of a table with one row per core and item. Each (core, name) stands once, so that a table is complete exactly
/// if it has cores times names rows.
template <class Record>
std::vector<Record> read_table(JsonNode const& summary, std::string const& table, std::uint64_t cores,
                               Record (*read_row)(JsonNode const&, std::uint64_t core)) {
    std::vector<Record> records;
    std::set<std::string> names;
    std::set<std::pair<std::uint64_t, std::string>> seen;
    for (JsonNode const& row : summary.at(table).items()) {
        std::uint64_t const core = row.at("core").unsigned_integer(0, cores - 1);
        records.push_back(read_row(row, core));
        std::string const name = records.back().name();
        names.insert(name);
        if (!seen.emplace(core, name).second)
            row.at("core").fail(fmt::format("one row only for its {}", name));
    }
    if (records.size() != cores * names.size())
        summary.at(table).fail(fmt::format("a row for each item of each of the {} {}", cores, cores_are()));
    return records;
}

/// The JSON of a summary.json. Throws InputError if it is none, for example cut off.
Json parse_summary(std::filesystem::path const& path) {
    return io::read_json_file(path, fmt::format("a summary of {} run", program_name()));
}

/// Empty: it does not say.
std::string program_of(Json const& summary) {
    auto const made_by = summary.find("made_by");
    if (made_by == summary.end() || !made_by->is_object())
        return {};
    auto const program = made_by->find("program");
    return program == made_by->end() || !program->is_string() ? std::string() : program->get<std::string>();
}

/// What a summary.json tells about a run: all of a RunRecord but folder and samples. Throws InputError for another
/// format or version, a missing or impossible value, and for tables in which a core lacks an item that another has, or
/// has one twice.
RunRecord read_summary(JsonNode const& summary) {
    if (summary.at("format").text() != format)
        summary.at("format").fail(format);
    if (summary.at("version").value() != version)
        summary.at("version").fail(std::to_string(version));
    if (auto const deadlock = summary.find("deadlock"))
        deadlock->at("cycle").fail("a run that ended: this one got stuck there (deadlock) and has no total_cycles");
    RunRecord run;
    run.total_cycles = figure(summary.at("total_cycles"));
    run.milliseconds = summary.at("milliseconds").number();
    if (run.milliseconds < 0)
        summary.at("milliseconds").fail("a number from 0");
    run.raster_cores = summary.at("raster_cores").unsigned_integer(1, most_cores);
    run.configuration = read_configuration(summary.at("configuration"));
    run.modules = read_table<ModuleRecord>(summary, "modules", run.raster_cores, read_module);
    if (run.modules.empty())
        summary.at("modules").fail("a row for each module");
    run.fifos = read_table<FifoRow>(summary, "fifos", run.raster_cores, read_fifo);
    run.loops = read_table<LoopRow>(summary, "loops", run.raster_cores, read_loop);
    return run;
}

}  // namespace

RunRecord read_run(std::filesystem::path const& folder) {
    io::require_folder(folder, "the output of " + program_name() + " run --out");
    std::filesystem::path const file = folder / "summary.json";
    Json const document = parse_summary(file);
    JsonNode const summary(file, document);
    RunRecord run = read_summary(summary);
    run.folder = folder.string();
    require_own_design(folder, program_of(document));
    run.samples = read_samples(folder / "samples.csv", run, figure(summary.at("samples")));
    check_all(folder / "fifos.csv", fifo_columns, run.fifos, "FIFOs");
    check_loops(folder / "loops.csv", run);
    if (fs::exists(folder / "all_loops.csv"))  // older runs have none, nor what Python passes on
        check_all(folder / "all_loops.csv", loop_columns, run.loops, "loops");
    return run;
}

RunRecord run_record(std::string const& name, std::string const& summary, std::vector<SampleStatistics> samples) {
    Json const document = Json::parse(summary);
    RunRecord run = read_summary(JsonNode(name, document));
    run.folder = name;
    run.samples = std::move(samples);
    return run;
}

}  // namespace dataflow::runs
