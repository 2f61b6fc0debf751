#include "kernel/compare/compare.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "kernel/compare/figure_changes.hpp"
#include "kernel/compare/setting_changes.hpp"
#include "kernel/config/design.hpp"
#include "kernel/figures/column_values.hpp"

namespace faster::runs {

namespace {

RunHead head_of(RunRecord const& run) {
    return {run.folder, run.samples.size(), run.raster_cores, run.total_cycles, run.milliseconds};
}

/// Every row a line of cells.
template <class Row, std::size_t N>
std::vector<std::vector<std::string>> cells_of(Columns<Row, N> columns, std::vector<Row> const& rows) {
    std::vector<std::vector<std::string>> cells;
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

std::vector<SampleChange> sample_changes(RunRecord const& a, RunRecord const& b, std::size_t count) {
    std::vector<SampleChange> changes;
    for (std::size_t i = 0; i < count; ++i)
        if (!(a.samples[i].counters == b.samples[i].counters))
            changes.push_back({i, a.samples[i].counters, b.samples[i].counters});
    return changes;
}

}  // namespace

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

}  // namespace faster::runs
