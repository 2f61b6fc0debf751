#include "kernel/compare/figure_changes.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "kernel/figures/column_values.hpp"

namespace faster::runs {

namespace {

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
        for (CycleClass const& one : module.classes)
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

}  // namespace

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

}  // namespace faster::runs
