#include "dataflow/tools/compare/compare.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "dataflow/run/config/design.hpp"
#include "dataflow/run/figures/column_values.hpp"

namespace dataflow::runs {

namespace {

using Settings = std::vector<ConfigurationEntry>;

std::map<std::string, std::string> by_key(Settings const& settings) {
    std::map<std::string, std::string> values;
    for (auto const& [key, value] : settings)
        values[key] = value;
    return values;
}

using Side = std::optional<std::uint64_t> Change::*;  ///< &Change::a or &Change::b

/// Figures of two runs side by side, in the order in which they came.
class SideBySide {
  public:
    void add(Side side, std::string const& item, std::string const& figure, std::uint64_t value) {
        auto const [found, is_new] = index_.try_emplace({item, figure}, rows_.size());
        if (is_new)
            rows_.push_back({item, figure, std::nullopt, std::nullopt});
        std::optional<std::uint64_t>& sum = rows_[found->second].*side;
        sum = sum.value_or(0) + value;
    }
    std::vector<Change> changes() const {
        std::vector<Change> changes = rows_;
        auto const is_same = [](Change const& change) { return change.difference() == 0; };
        changes.erase(std::remove_if(changes.begin(), changes.end(), is_same), changes.end());
        sort_by_difference(changes);
        return changes;
    }

  private:
    std::vector<Change> rows_;
    std::map<std::pair<std::string, std::string>, std::size_t> index_;
};

void add_module_cycles(RunRecord const& run, Side side, SideBySide& figures) {
    for (ModuleRecord const& module : run.modules)
        for (NamedCycles const& one : module.classes)
            figures.add(side, module.name(), one.name, one.cycles);
}

/// Those of the columns that a list compares.
template <class Row, std::size_t N>
void add_columns(std::string const& list, Columns<Row, N> columns, std::vector<Row> const& rows, Side side,
                 SideBySide& figures) {
    for (Row const& row : over_cores(columns, rows))
        for (Column<Row> const& column : columns)
            if (column.is_compared_in(list))
                figures.add(side, row.name(), column.name, *figure_in(column, row));
}

/// Of an even number of samples, the median is the smaller of the two in the middle, as in the report of a run.
void add_sample_latencies(RunRecord const& run, Side side, SideBySide& figures) {
    std::vector<Cycles> latencies;
    for (SampleStatistics const& sample : run.samples)
        latencies.push_back(sample.latency_cycles());
    if (latencies.empty())
        return;
    std::sort(latencies.begin(), latencies.end());
    figures.add(side, "median", "latency_cycles", latencies[(latencies.size() - 1) / 2]);
    figures.add(side, "max", "latency_cycles", latencies.back());
}

constexpr char const* module_cycles = "module_cycles";
constexpr char const* sample_latencies = "sample_latencies";

void add_list(std::string const& list, RunRecord const& run, Side side, SideBySide& figures) {
    if (list == module_cycles)
        add_module_cycles(run, side, figures);
    if (list == sample_latencies)
        add_sample_latencies(run, side, figures);
    add_columns(list, fifo_columns, run.fifos, side, figures);
    add_columns(list, loop_columns, run.loops, side, figures);
}

/// The figures that moved from run A to run B, a list per kind; lists without changes are there, but empty. Figures of
/// several cores are summed, occupancies and initiation intervals are the largest of any core.
std::vector<ChangeList> figure_changes(RunRecord const& a, RunRecord const& b) {
    std::vector<ChangeList> lists{
        {module_cycles, "Modules: where the cycles went [lane-cycles]", {}},
        {"fifo_stalls", "FIFOs: stalls [lane-cycles]", {}},
        {"fifo_occupancies", "FIFOs: largest occupancy of any core [tokens]", {}},
        {"loop_losses", "Loops: lost to ports and recurrences [lane-cycles]", {}},
        {"loop_intervals", "Loops: initiation intervals [cycles]", {}},
        {"loop_iterations", "Loops: iterations", {}},
        {sample_latencies, "Sample latency, queueing included [cycles]", {}},
    };
    for (ChangeList& list : lists) {
        SideBySide figures;
        add_list(list.name, a, &Change::a, figures);
        add_list(list.name, b, &Change::b, figures);
        list.changes = figures.changes();
    }
    return lists;
}

RunHead head_of(RunRecord const& run) {
    return {run.folder, run.samples.size(), run.raster_cores, run.total_cycles, run.milliseconds};
}

/// Every row a line of cells.
template <class Row, std::size_t N>
std::vector<std::vector<std::string>> cells_of(Columns<Row, N> columns, std::vector<Row> const& rows) {
    std::vector<std::vector<std::string>> cells;
    cells.reserve(rows.size());
    for (Row const& row : rows)
        cells.push_back(csv_cells(columns, row));
    return cells;
}

bool are_same_samples(SampleStatistics const& a, SampleStatistics const& b) {
    return csv_cells(sample_columns, a) == csv_cells(sample_columns, b) && a.counters == b.counters;
}

bool are_identical(RunRecord const& a, RunRecord const& b) {
    return a.total_cycles == b.total_cycles && a.milliseconds == b.milliseconds && a.raster_cores == b.raster_cores &&
           a.configuration == b.configuration && a.modules == b.modules &&
           cells_of(fifo_columns, a.fifos) == cells_of(fifo_columns, b.fifos) &&
           cells_of(loop_columns, a.loops) == cells_of(loop_columns, b.loops) &&
           std::equal(a.samples.begin(), a.samples.end(), b.samples.begin(), b.samples.end(), are_same_samples);
}

std::vector<std::string> notes_on(RunRecord const& a, RunRecord const& b) {
    std::vector<std::string> notes;
    if (a.raster_cores != b.raster_cores)
        notes.push_back(fmt::format("A has {} {}, B {}; figures are sums over all of them", a.raster_cores, cores_are(),
                                    b.raster_cores));
    if (a.samples.size() != b.samples.size())
        notes.push_back(fmt::format("A has {} samples, B {}; results are compared for those that both have",
                                    a.samples.size(), b.samples.size()));
    return notes;
}

/// Every core is built alike, so core 0 speaks for all.
std::vector<ConfigurationEntry> fifo_shapes_of(RunRecord const& run) {
    std::vector<ConfigurationEntry> settings;
    for (FifoRow const& fifo : run.fifos) {
        if (fifo.core != 0)
            continue;
        settings.push_back({fifo.name() + ".depth", std::to_string(fifo.depth)});
        settings.push_back({fifo.name() + ".kind", nlohmann::json(fifo.kind_name).dump()});
    }
    return settings;
}

/// Where both have them: a design may count more in one configuration than in another.
bool are_equal(Counters const& a, Counters const& b) {
    auto const common = static_cast<std::ptrdiff_t>(std::min(a.size(), b.size()));
    return std::equal(a.begin(), a.begin() + common, b.begin());
}

std::vector<SampleChange> sample_changes(RunRecord const& a, RunRecord const& b, std::size_t count) {
    std::vector<SampleChange> changes;
    for (std::size_t i = 0; i < count; ++i)
        if (!are_equal(a.samples[i].counters, b.samples[i].counters))
            changes.push_back({i, a.samples[i].counters, b.samples[i].counters});
    return changes;
}

}  // namespace

std::vector<SettingChange> joined(Settings const& a, Settings const& b) {
    auto const in_a = by_key(a);
    auto const in_b = by_key(b);
    std::vector<SettingChange> rows;
    for (auto const& [key, value] : a) {
        auto const other = in_b.find(key);
        rows.push_back({key, value, other == in_b.end() ? std::nullopt : std::optional(other->second)});
    }
    for (auto const& [key, value] : b)
        if (in_a.count(key) == 0)
            rows.push_back({key, std::nullopt, value});
    return rows;
}

std::vector<SettingChange> changed(std::vector<SettingChange> rows) {
    auto const is_same = [](SettingChange const& row) { return row.a == row.b; };
    rows.erase(std::remove_if(rows.begin(), rows.end(), is_same), rows.end());
    return rows;
}

Comparison compare(RunRecord const& a, RunRecord const& b) {
    Comparison comparison;
    comparison.a = head_of(a);
    comparison.b = head_of(b);
    comparison.identical = are_identical(a, b);
    comparison.notes = notes_on(a, b);
    std::vector<SettingChange> const keys = joined(a.configuration, b.configuration);
    comparison.keys = keys.size();
    comparison.configuration = changed(keys);
    comparison.compared_samples = std::min(a.samples.size(), b.samples.size());
    comparison.samples = sample_changes(a, b, comparison.compared_samples);
    comparison.fifo_shapes = changed(joined(fifo_shapes_of(a), fifo_shapes_of(b)));
    comparison.figures = figure_changes(a, b);
    return comparison;
}

}  // namespace dataflow::runs
