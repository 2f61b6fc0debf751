#include "runs/figure_changes.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

#include "stats/column_values.hpp"

namespace faster::runs {

namespace {

/// Figures of one run by item and name, over all cores, in the order in which they came.
class Figures {
  public:
    struct Figure {
        std::string item;
        std::string name;
        std::uint64_t value = 0;
    };

    void add(std::string const& item, std::string const& name, std::uint64_t value) {
        auto const [found, is_new] = index_.try_emplace({item, name}, figures_.size());
        if (is_new)
            figures_.push_back({item, name});
        figures_[found->second].value += value;
    }
    std::optional<std::uint64_t> find(std::string const& item, std::string const& name) const {
        auto const found = index_.find({item, name});
        return found == index_.end() ? std::nullopt : std::optional(figures_[found->second].value);
    }
    std::vector<Figure> const& all() const { return figures_; }

  private:
    std::vector<Figure> figures_;
    std::map<std::pair<std::string, std::string>, std::size_t> index_;
};

bool is_larger(Change const& left, Change const& right) {
    return std::abs(left.difference()) > std::abs(right.difference());
}

std::vector<Change> changes(Figures const& a, Figures const& b) {
    std::vector<Change> found;
    for (auto const& [item, name, value] : a.all())
        found.push_back({item, name, value, b.find(item, name)});
    for (auto const& [item, name, value] : b.all())
        if (!a.find(item, name))
            found.push_back({item, name, std::nullopt, value});
    found.erase(std::remove_if(found.begin(), found.end(), [](Change const& c) { return c.difference() == 0; }),
                found.end());
    std::stable_sort(found.begin(), found.end(), is_larger);
    return found;
}

void add_module_cycles(RunRecord const& run, Figures& figures) {
    for (ModuleRecord const& module : run.modules)
        for (CycleClass const& one : module.classes)
            figures.add(module.name(), one.name, one.cycles);
}

/// Those of the columns that a list compares.
template <class Row, std::size_t N>
void add_columns(std::string const& list, Columns<Row, N> columns, std::vector<Row> const& rows, Figures& figures) {
    for (Row const& row : over_cores(columns, rows))
        for (Column<Row> const& column : columns)
            if (column.is_compared_in(list))
                figures.add(row.name(), column.name, *figure_in(column, row));
}

/// Of an even number of samples, the median is the smaller of the two in the middle, as in the report of a run.
void add_sample_latencies(RunRecord const& run, Figures& figures) {
    std::vector<Cycles> latencies;
    for (SampleStatistics const& sample : run.samples)
        latencies.push_back(sample.latency_cycles());
    if (latencies.empty())
        return;
    std::sort(latencies.begin(), latencies.end());
    figures.add("median", "latency_cycles", latencies[(latencies.size() - 1) / 2]);
    figures.add("max", "latency_cycles", latencies.back());
}

constexpr char const* module_cycles = "module_cycles";
constexpr char const* sample_latencies = "sample_latencies";

Figures figures_of(std::string const& list, RunRecord const& run) {
    Figures figures;
    if (list == module_cycles)
        add_module_cycles(run, figures);
    if (list == sample_latencies)
        add_sample_latencies(run, figures);
    add_columns(list, fifo_columns, run.fifos, figures);
    add_columns(list, loop_columns, run.loops, figures);
    return figures;
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
    for (ChangeList& list : lists)
        list.changes = changes(figures_of(list.name, a), figures_of(list.name, b));
    return lists;
}

}  // namespace faster::runs
