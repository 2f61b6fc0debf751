#include "dataflow/run/figures/run_statistics.hpp"

#include <algorithm>
#include <functional>

#include "dataflow/base/enumerators.hpp"

namespace dataflow {

static_assert(cycle_class_count == enum_size<CycleClass>(), "every class of cycles has a name and a meaning");

Cycles RunStatistics::deadlock_cycle() const {
    Cycles latest = 0;
    for (StuckProcess const& process : stuck)
        latest = std::max(latest, process.since_cycle);
    return latest;
}

std::size_t RunStatistics::last_core() const {
    auto const ends_before = [](CoreStatistics const& a, CoreStatistics const& b) { return a.end_cycle < b.end_cycle; };
    return static_cast<std::size_t>(std::max_element(cores.begin(), cores.end(), ends_before) - cores.begin());
}

std::vector<StuckProcess> RunStatistics::wait_cycle() const {
    auto const successor = [this](StuckProcess const& process) {
        return std::find_if(stuck.begin(), stuck.end(), [&process](StuckProcess const& other) {
            return other.core == process.core && other.process == process.waits_for;
        });
    };
    for (auto start = stuck.begin(); start != stuck.end(); ++start) {
        std::vector<StuckProcess> path;
        auto at = start;
        do {
            path.push_back(*at);
            at = successor(*at);
        } while (at != stuck.end() && at != start && path.size() <= stuck.size());
        if (at == start)
            return path;
    }
    return {};
}

namespace {
ProcessStatistics empty_process(Machine const& machine) {
    ProcessStatistics process;
    process.stalls.resize(machine.fifos.size());
    process.port_conflicts.resize(machine.memories.size());
    return process;
}

template <class Row> void add(Row& sum, Row const& cycles) {
    std::transform(sum.begin(), sum.end(), cycles.begin(), sum.begin(), std::plus<>());
}
}  // namespace

CoreStatistics empty_core(Machine const& machine) {
    CoreStatistics core;
    core.fifos.resize(machine.fifos.size());
    core.loops.resize(machine.loops.size());
    core.processes.resize(machine.processes.size(), empty_process(machine));
    return core;
}

ProcessStatistics process_sum(RunStatistics const& run, std::size_t module) {
    ProcessStatistics sum = empty_process(run.machine);
    for (CoreStatistics const& core : run.cores) {
        ProcessStatistics const& process = core.processes[module];
        add(sum.cycles, process.cycles);
        add(sum.stalls, process.stalls);
        add(sum.port_conflicts, process.port_conflicts);
    }
    return sum;
}

namespace {
std::string unread_tokens(RunStatistics const& run, bool may_be_kept) {
    std::string text;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t i = 0; i < run.machine.fifos.size(); ++i) {
            FifoStatistics const& fifo = run.cores[core].fifos[i];
            if (fifo.writes != fifo.reads && run.machine.fifos[i].may_keep_tokens == may_be_kept)
                text += (text.empty() ? "" : ", ") + run.machine.fifos[i].name + " of core " + std::to_string(core) +
                        " (" + std::to_string(fifo.writes - fifo.reads) + ")";
        }
    return text;
}
}  // namespace

std::string leftover_tokens(RunStatistics const& run) { return unread_tokens(run, false); }

std::string kept_tokens(RunStatistics const& run) { return unread_tokens(run, true); }

}  // namespace dataflow
