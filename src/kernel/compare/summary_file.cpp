#include "kernel/compare/summary_file.hpp"

#include <fmt/format.h>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "kernel/base/files/json_file.hpp"
#include "kernel/base/program_name.hpp"
#include "kernel/config/design.hpp"
#include "kernel/figures/column_values.hpp"

namespace faster::runs {

namespace {

constexpr char const* format = "faster-summary";
constexpr std::uint64_t version = 1;
constexpr std::uint64_t most_cores = 1024;  // as accelerator.raster_cores

std::vector<ConfigurationEntry> read_configuration(JsonSection const& configuration) {
    std::vector<ConfigurationEntry> entries;
    for (auto const& item : configuration.object().items())
        entries.push_back({item.key(), configuration.section(item.key()).at("value").dump()});
    return entries;
}

bool is_cycle_class(std::string_view name) {
    constexpr std::string_view ending = "_cycles";
    return name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending;
}

/// Values of another type (a breakdown of a class, say) are for others to read.
std::vector<CycleClass> read_classes(JsonSection const& row) {
    std::vector<CycleClass> classes;
    for (auto const& item : row.object().items())
        if (is_cycle_class(item.key()) && !item.value().is_structured())
            classes.push_back({item.key(), row.integer(item.key())});
    return classes;
}

ModuleRecord read_module(JsonSection const& row, std::uint64_t core) {
    return {core, row.text("module"), read_classes(row)};
}

/// A row of the columns that the CSV files have too.
template <class Row, std::size_t N> Row read_row(JsonSection const& section, Columns<Row, N> columns) {
    Row row;
    for (Column<Row> const& column : columns) {
        if (!column.is_in_csv())
            continue;
        if (auto* const figure = place_of<std::uint64_t>(column, row))
            *figure = section.integer(column.name);
        if (auto* const text = place_of<std::string>(column, row))
            *text = section.text(column.name);
    }
    return row;
}

FifoRow read_fifo(JsonSection const& row, std::uint64_t) { return read_row(row, fifo_columns); }
LoopRow read_loop(JsonSection const& row, std::uint64_t) { return read_row(row, loop_columns); }

/// Rows of a table with one row per core and item. Each (core, name) stands once, so that a table is complete exactly
/// if it has cores times names rows.
template <class Record>
std::vector<Record> read_table(JsonSection const& summary, std::string const& table, std::uint64_t cores,
                               Record (*read_row)(JsonSection const&, std::uint64_t core)) {
    Json const& rows = summary.array_at(table);
    std::vector<Record> records;
    std::set<std::string> names;
    std::set<std::pair<std::uint64_t, std::string>> seen;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        JsonSection const row = summary.row(table, rows, i);
        std::uint64_t const core = row.integer("core", 0, cores - 1);
        records.push_back(read_row(row, core));
        std::string const name = records.back().name();
        names.insert(name);
        if (!seen.emplace(core, name).second)
            row.fail("core", fmt::format("one row only for its {}", name));
    }
    if (records.empty() || records.size() != cores * names.size())
        summary.fail(table, fmt::format("a row for each item of each of the {} {}", cores, cores_are()));
    return records;
}

}  // namespace

Json parse_summary(std::filesystem::path const& path) {
    return io::read_json_file(path, fmt::format("a summary of {} run", program_name()));
}

RunRecord read_summary(JsonSection const& summary) {
    if (summary.text("format") != format)
        summary.fail("format", format);
    if (summary.at("version") != version)
        summary.fail("version", std::to_string(version));
    RunRecord run;
    run.total_cycles = summary.integer("total_cycles");
    run.milliseconds = summary.number("milliseconds");
    run.raster_cores = summary.integer("raster_cores", 1, most_cores);
    run.configuration = read_configuration(summary.section("configuration"));
    run.modules = read_table<ModuleRecord>(summary, "modules", run.raster_cores, read_module);
    run.fifos = read_table<FifoRow>(summary, "fifos", run.raster_cores, read_fifo);
    run.loops = read_table<LoopRow>(summary, "loops", run.raster_cores, read_loop);
    return run;
}

}  // namespace faster::runs
