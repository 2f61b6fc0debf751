#include "support/run_cells.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/run/figures/column_values.hpp"
#include "faster/dataflow_names.hpp"
#include "support/counters.hpp"

namespace faster::testing {

namespace {

/// Collects cells under a common prefix.
class CellList {
  public:
    void at(std::string prefix) { prefix_ = std::move(prefix); }
    void add(std::string const& name, std::uint64_t value) {
        cells_.push_back({prefix_ + name, std::to_string(value)});
    }
    void add(std::string const& name, std::string const& value) { cells_.push_back({prefix_ + name, value}); }
    Cells take() { return std::move(cells_); }

  private:
    std::string prefix_;
    Cells cells_;
};

std::string in_core(std::size_t core, std::string const& what) { return "core " + std::to_string(core) + ", " + what; }
std::string in_loop(std::size_t core, std::size_t loop) {
    return in_core(core, std::string("loop ") + name_of(loop_ids[loop].module) + "." + loop_ids[loop].name + ", ");
}
std::string in_fifo(std::size_t core, std::size_t fifo) {
    return in_core(core, std::string("fifo ") + fifo_ids[fifo].name + ", ");
}
std::string in_process(std::size_t core, std::size_t process) {
    return in_core(core, std::string("process ") + module_ids[process].name + ", ");
}

Counters const& row_of(SampleStatistics const& sample) { return sample.counters; }
Counters row_of(TwinSample const& sample) { return counters_of(sample.counters); }

template <class Sample> void add_sample(CellList& cells, std::size_t index, Sample const& sample) {
    cells.at("sample " + std::to_string(index) + ", ");
    cells.add("start_cycle", sample.start_cycle);
    cells.add("end_cycle", sample.end_cycle);
    Counters const& counters = row_of(sample);
    for (std::size_t i = 0; i < counter_names.size(); ++i)
        cells.add(counter_names[i], counters.at(i));
}

template <class Fifo> void add_fifo(CellList& cells, Fifo const& fifo) {
    cells.add("writes", fifo.writes);
    cells.add("reads", fifo.reads);
    cells.add("full_stall_cycles", fifo.full_stall_cycles);
    cells.add("empty_stall_cycles", fifo.empty_stall_cycles);
    cells.add("max_occupancy", fifo.max_occupancy);
}

template <class Loop> void add_loop(CellList& cells, Loop const& loop) {
    cells.add("ii", loop.ii);
    cells.add("entries", loop.entries);
    cells.add("iterations", loop.iterations);
    cells.add("port_conflict_cycles", loop.port_conflict_cycles);
    cells.add("recurrence_cycles", loop.recurrence_cycles);
    cells.add("limited_by", loop.limited_by);
}

void add_stalls(CellList& cells, ProcessStatistics const& process, Cycles) {
    // The twin counts the wait for the first token as a stall.
    cells.add("empty_stall", process[CycleClass::empty_stall] + process[CycleClass::idle_before]);
    cells.add("full_stall", process[CycleClass::full_stall]);
    cells.add("memory_stall", process[CycleClass::memory_stall]);
    cells.add("idle", process[CycleClass::idle_after]);
}
/// What is waited for may come when the run is over.
Cycles in_run(std::vector<Cycles> const& stalls, Cycles total_cycles) {
    return static_cast<Cycles>(std::lower_bound(stalls.begin(), stalls.end(), total_cycles) - stalls.begin());
}
void add_stalls(CellList& cells, TwinProcess const& process, Cycles total_cycles) {
    cells.add("empty_stall", in_run(process.empty_stalls, total_cycles));
    cells.add("full_stall", in_run(process.full_stalls, total_cycles));
    cells.add("memory_stall", process.memory_stall);
    cells.add("idle", total_cycles - std::min(process.end_cycle, total_cycles));
}

template <class Fifos> void add_fifos(CellList& cells, std::size_t core, Fifos const& fifos) {
    for (std::size_t i = 0; i < fifo_count; ++i) {
        cells.at(in_fifo(core, i));
        add_fifo(cells, fifos[i]);
    }
}
template <class Loops> void add_loops(CellList& cells, std::size_t core, Loops const& loops) {
    for (std::size_t i = 0; i < loop_count; ++i) {
        cells.at(in_loop(core, i));
        add_loop(cells, loops[i]);
    }
}
template <class Processes>
void add_processes(CellList& cells, std::size_t core, Processes const& processes, Cycles total_cycles) {
    for (std::size_t i = 0; i < module_count; ++i) {
        cells.at(in_process(core, i));
        add_stalls(cells, processes[i], total_cycles);
    }
}

/// A master that asked for nothing has no cells.
void add_master(CellList& cells, std::size_t core, std::string const& name, std::uint64_t bursts, std::uint64_t bytes,
                Cycles latency_most) {
    if (bursts == 0)
        return;
    cells.at(in_core(core, "master " + name + ", "));
    cells.add("bursts", bursts);
    cells.add("bytes", bytes);
    cells.add("latency_most", latency_most);
}

void add_memory(CellList& cells, MemoryTraffic const& memory) {
    for (MasterStatistics const& master : memory.masters)
        add_master(cells, master.core, master.master, master.bursts, master.bytes, master.latency_most);
    for (std::size_t port = 0; port < memory.port_beats.size(); ++port) {
        cells.at("port " + std::to_string(port) + ", ");
        cells.add("beats", memory.port_beats[port]);
    }
    cells.at("controller, ");
    cells.add("busy_ps", memory.controller_busy_ps);
}
void add_memory(CellList& cells, TwinResult const& twin) {
    constexpr std::array<char const*, master_count> names{"header", "vertex", "observation", "result"};
    for (std::size_t core = 0; core < twin.traffic.size(); ++core) {
        for (std::size_t i = 0; i < master_count; ++i) {
            TwinTraffic const& traffic = twin.traffic[core][i];
            add_master(cells, core, names[i], traffic.bursts, traffic.bytes, traffic.latency_max);
        }
    }
    for (std::size_t port = 0; port < twin.port_beats.size(); ++port) {
        cells.at("port " + std::to_string(port) + ", ");
        cells.add("beats", twin.port_beats[port]);
    }
    cells.at("controller, ");
    cells.add("busy_ps", twin.controller_ps);
}

}  // namespace

Cells cells_of(RunStatistics const& run, Part part) {
    CellList cells;
    if (part == Part::Memory && run.memory) {
        add_memory(cells, *run.memory);
        cells.at("");
        cells.add("load_cycles", run.load_cycles);
    }
    if (part == Part::Samples) {
        cells.add("total_cycles", run.total_cycles);
        for (std::size_t i = 0; i < run.samples.size(); ++i)
            add_sample(cells, run.samples[i].sample, run.samples[i]);
    }
    for (std::size_t k = 0; k < run.cores.size(); ++k) {
        if (part == Part::Fifos)
            add_fifos(cells, k, run.cores[k].fifos);
        if (part == Part::Loops)
            add_loops(cells, k, run.cores[k].loops);
        if (part == Part::Stalls)
            add_processes(cells, k, run.cores[k].processes, run.total_cycles);
    }
    return cells.take();
}

Cells cells_of(TwinResult const& twin, Part part) {
    CellList cells;
    if (part == Part::Memory && !twin.traffic.empty()) {
        add_memory(cells, twin);
        cells.at("");
        cells.add("load_cycles", twin.load_cycles);
    }
    if (part == Part::Samples) {
        cells.add("total_cycles", twin.total_cycles);
        for (std::size_t i = 0; i < twin.samples.size(); ++i)
            add_sample(cells, i, twin.samples[i]);
    }
    for (std::size_t k = 0; k < twin.fifos.size(); ++k) {
        if (part == Part::Fifos)
            add_fifos(cells, k, twin.fifos[k]);
        if (part == Part::Loops)
            add_loops(cells, k, twin.loops[k]);
        if (part == Part::Stalls)
            add_processes(cells, k, twin.processes[k], twin.total_cycles - twin.load_cycles);
    }
    return cells.take();
}

namespace {
/// What a process waited in a step that never came to pass is not the same from both engines, nor what is left of its
/// other classes where another core's last result ends the count. No output has either.
void leave_out_classes(Cells& cells) {
    auto const is_of_class = [](Cell const& cell) {
        return cell.name.find("stall") != std::string::npos || cell.name.find(", process ") != std::string::npos;
    };
    cells.erase(std::remove_if(cells.begin(), cells.end(), is_of_class), cells.end());
}
}  // namespace

Cells all_cells(RunStatistics const& run) {
    Cells cells;
    for (Part const part : {Part::Samples, Part::Fifos, Part::Loops, Part::Stalls, Part::Memory})
        for (Cell& cell : cells_of(run, part))
            cells.push_back(std::move(cell));
    CellList more;
    for (SampleStatistics const& sample : run.samples) {
        more.at("sample " + std::to_string(sample.sample) + ", ");
        more.add("core", sample.core);
    }
    for (std::size_t k = 0; k < run.cores.size(); ++k) {
        more.at(in_core(k, ""));
        more.add("samples", run.cores[k].samples);
        more.add("end_cycle", run.cores[k].end_cycle);
        for (std::size_t i = 0; i < fifo_count; ++i) {
            FifoStatistics const& fifo = run.cores[k].fifos[i];
            more.at(in_fifo(k, i));
            more.add("kind", static_cast<std::uint64_t>(fifo.kind));
            for (auto const& column : fifo_columns)
                more.add(column.name, cell_in(column, FifoRow{fifo, k, "", ""}));
        }
        for (std::size_t i = 0; i < loop_count; ++i) {
            LoopStatistics const& loop = run.cores[k].loops[i];
            more.at(in_loop(k, i));
            for (auto const& column : loop_columns)
                more.add(column.name, cell_in(column, LoopRow{loop, k, "", ""}));
            more.add("bram", loop.bram);
        }
        for (std::size_t i = 0; i < module_count; ++i) {
            ProcessStatistics const& process = run.cores[k].processes[i];
            more.at(in_process(k, i));
            for (std::size_t c = 0; c < cycle_class_count; ++c)
                more.add(cycle_class_names[c], process.cycles[c]);
            for (std::size_t f = 0; f < fifo_count; ++f)
                more.add(std::string("stall ") + fifo_ids[f].name, process.stalls[f]);
            for (std::size_t b = 0; b < bram_count; ++b)
                more.add(std::string("conflict ") + bram_ids[b].name, process.port_conflicts[b]);
        }
    }
    for (Cell& cell : more.take())
        cells.push_back(std::move(cell));
    if (run.deadlocked())
        leave_out_classes(cells);
    return cells;
}

Cells stuck_cells(RunStatistics const& run) {
    CellList cells;
    for (StuckProcess const& stuck : run.stuck) {
        cells.at(in_core(stuck.core, stuck.process + ", "));
        cells.add("fifo", stuck.fifo);
        cells.add("to_write", std::uint64_t{stuck.to_write});
        cells.add("occupancy", stuck.occupancy);
        cells.add("capacity", stuck.capacity);
        cells.add("since_cycle", stuck.since_cycle);
        cells.add("waits_for", stuck.waits_for);
    }
    return cells.take();
}

Cells path_cells(RunStatistics const& run) {
    CellList cells;
    cells.add("core", run.critical_path.value().core);
    for (PathRow const& row : run.critical_path->rows) {
        std::string const loop = row.loop ? loop_ids.at(*row.loop).name : "outside loops";
        std::string const item = row.fifo ? fifo_ids.at(*row.fifo).name : row.bram;
        cells.at(std::string(module_ids.at(row.module).name) + ", " + loop + ", " +
                 std::string(enumerator_name(row.cause)) + " " + item + ", ");
        cells.add("cycles", row.cycles);
        cells.add("crossings", row.crossings);
    }
    return cells.take();
}

Cells position_cells(RunStatistics const& run) {
    CellList cells;
    for (StuckProcess const& stuck : run.stuck) {
        cells.at(in_core(stuck.core, stuck.process + ", "));
        cells.add("position", stuck.position);
    }
    return cells.take();
}

std::string first_difference(Cells const& a, Cells const& b) {
    std::size_t const common = std::min(a.size(), b.size());
    for (std::size_t i = 0; i < common; ++i) {
        if (a[i].name != b[i].name)
            return a[i].name + " against " + b[i].name;
        if (a[i].value != b[i].value)
            return a[i].name + ": " + a[i].value + " against " + b[i].value;
    }
    if (a.size() != b.size())
        return std::to_string(a.size()) + " figures against " + std::to_string(b.size());
    return {};
}

}  // namespace faster::testing
