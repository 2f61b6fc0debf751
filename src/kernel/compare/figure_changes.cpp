#include "kernel/compare/figure_changes.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <utility>

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

    void add(std::string const& item, std::string const& name, std::uint64_t value) { at(item, name) += value; }
    void raise(std::string const& item, std::string const& name, std::uint64_t value) {
        std::uint64_t& largest = at(item, name);
        largest = std::max(largest, value);
    }
    std::optional<std::uint64_t> find(std::string const& item, std::string const& name) const {
        auto const found = index_.find({item, name});
        return found == index_.end() ? std::nullopt : std::optional(figures_[found->second].value);
    }
    std::vector<Figure> const& all() const { return figures_; }

  private:
    std::uint64_t& at(std::string const& item, std::string const& name) {
        auto const [found, is_new] = index_.try_emplace({item, name}, figures_.size());
        if (is_new)
            figures_.push_back({item, name});
        return figures_[found->second].value;
    }

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

Figures module_cycles(RunRecord const& run) {
    Figures figures;
    for (ModuleRecord const& module : run.modules)
        for (CycleClass const& one : module.classes)
            figures.add(module.name(), one.name, one.cycles);
    return figures;
}

Figures fifo_stalls(RunRecord const& run) {
    Figures figures;
    for (FifoRecord const& fifo : run.fifos) {
        figures.add(fifo.name(), "full_stall_cycles", fifo.full_stall_cycles);
        figures.add(fifo.name(), "empty_stall_cycles", fifo.empty_stall_cycles);
    }
    return figures;
}

Figures fifo_occupancies(RunRecord const& run) {
    Figures figures;
    for (FifoRecord const& fifo : run.fifos)
        figures.raise(fifo.name(), "max_occupancy", fifo.max_occupancy);
    return figures;
}

Figures loop_intervals(RunRecord const& run) {
    Figures figures;
    for (LoopRecord const& loop : run.loops)
        figures.raise(loop.name(), "ii", loop.ii);
    return figures;
}

Figures loop_losses(RunRecord const& run) {
    Figures figures;
    for (LoopRecord const& loop : run.loops) {
        figures.add(loop.name(), "port_conflict_cycles", loop.port_conflict_cycles);
        figures.add(loop.name(), "recurrence_cycles", loop.recurrence_cycles);
    }
    return figures;
}

Figures loop_iterations(RunRecord const& run) {
    Figures figures;
    for (LoopRecord const& loop : run.loops)
        figures.add(loop.name(), "iterations", loop.iterations);
    return figures;
}

/// Of an even number of samples, the median is the smaller of the two in the middle, as in the report of a run.
Figures sample_latencies(RunRecord const& run) {
    std::vector<Cycles> latencies;
    for (SampleRecord const& sample : run.samples)
        latencies.push_back(sample.latency_cycles());
    Figures figures;
    if (latencies.empty())
        return figures;
    std::sort(latencies.begin(), latencies.end());
    figures.add("median", "latency_cycles", latencies[(latencies.size() - 1) / 2]);
    figures.add("max", "latency_cycles", latencies.back());
    return figures;
}

}  // namespace

std::vector<ChangeList> figure_changes(RunRecord const& a, RunRecord const& b) {
    auto const list = [&](char const* name, char const* title, Figures (*of)(RunRecord const&)) {
        return ChangeList{name, title, changes(of(a), of(b))};
    };
    return {list("module_cycles", "Modules: where the cycles went [lane-cycles]", module_cycles),
            list("fifo_stalls", "FIFOs: stalls [lane-cycles]", fifo_stalls),
            list("fifo_occupancies", "FIFOs: largest occupancy of any core [tokens]", fifo_occupancies),
            list("loop_losses", "Loops: lost to ports and recurrences [lane-cycles]", loop_losses),
            list("loop_intervals", "Loops: initiation intervals [cycles]", loop_intervals),
            list("loop_iterations", "Loops: iterations", loop_iterations),
            list("sample_latencies", "Sample latency, queueing included [cycles]", sample_latencies)};
}

}  // namespace faster::runs
