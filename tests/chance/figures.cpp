#include "chance/figures.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace faster::chance {

namespace {

void add_fifos(RunStatistics const& run, std::size_t core, std::vector<std::string>& lines, bool hand_over = false) {
    for (std::size_t i = 0; i < run.machine.fifos.size(); ++i) {
        if ((run.machine.fifos[i].hands_over > 0) != hand_over)
            continue;
        FifoStatistics const& fifo = run.cores[core].fifos[i];
        lines.push_back(fifo_line(core, run.machine.fifos[i].name, fifo.writes, fifo.reads, fifo.full_stall_cycles,
                                  fifo.empty_stall_cycles, fifo.max_occupancy));
    }
}

void add_tables(RunStatistics const& run, std::size_t core, std::vector<std::string>& lines) {
    add_fifos(run, core, lines);
    CoreStatistics const& of_core = run.cores[core];
    for (std::size_t i = 0; i < run.machine.loops.size(); ++i) {
        LoopStatistics const& loop = of_core.loops[i];
        lines.push_back(loop_line(core, run.machine.loop_name(i), loop.ii, loop.entries, loop.iterations));
    }
    for (std::size_t i = 0; i < run.machine.processes.size(); ++i) {
        ProcessStatistics const& process = of_core.processes[i];
        lines.push_back(process_line(core, run.machine.processes[i].name, process[CycleClass::memory_stall],
                                     process[CycleClass::empty_stall], process[CycleClass::full_stall],
                                     process[CycleClass::idle_before], process[CycleClass::idle_after]));
        bool const adds_up =
            process.sum() == run.total_cycles && std::all_of(process.cycles.begin(), process.cycles.end(),
                                                             [&](Cycles cycles) { return cycles <= run.total_cycles; });
        if (!adds_up)
            lines.emplace_back("its classes do not add up to the total");
    }
}

}  // namespace

std::string sample_line(std::uint64_t sample, Cycles begin, Cycles end) {
    return fmt::format("sample {}: {} to {}", sample, begin, end);
}
std::string fifo_line(std::size_t core, std::string const& name, std::uint64_t writes, std::uint64_t reads, Cycles full,
                      Cycles empty, std::uint64_t most) {
    return fmt::format("core {} FIFO {}: {} writes, {} reads, full {}, empty {}, most {}", core, name, writes, reads,
                       full, empty, most);
}
std::string loop_line(std::size_t core, std::string const& name, Cycles ii, std::uint64_t entries,
                      std::uint64_t iterations) {
    return fmt::format("core {} loop {}: II {}, {} entries, {} iterations", core, name, ii, entries, iterations);
}
std::string process_line(std::size_t core, std::string const& name, Cycles memory, Cycles empty, Cycles full,
                         Cycles idle_before, Cycles idle_after) {
    return fmt::format("core {} process {}: memory {}, empty {}, full {}, idle {} before, {} after", core, name, memory,
                       empty, full, idle_before, idle_after);
}
std::string wait_line(std::size_t core, std::string const& process, std::string const& fifo, bool to_write,
                      Cycles since, std::string const& other, std::uint64_t occupancy) {
    return fmt::format("core {} {} waits for {} to {} {}, which holds {}, since {}", core, process, other,
                       to_write ? "read" : "write", fifo, occupancy, since);
}

void put(ValueWriter& writer, Figures const& figures) {
    writer.put(figures.is_stuck, figures.total_cycles);
    for (std::vector<std::string> const* const lines : {&figures.lines, &figures.hand_overs}) {
        writer.put(lines->size());
        for (std::string const& line : *lines)
            writer.put(line);
    }
}

Figures figures_from(ValueReader& reader) {
    Figures figures;
    reader.get(figures.is_stuck);
    reader.get(figures.total_cycles);
    for (std::vector<std::string>* const lines : {&figures.lines, &figures.hand_overs}) {
        lines->resize(reader.get_size());
        for (std::string& line : *lines)
            reader.get(line);
    }
    return figures;
}

Figures figures_of(RunStatistics const& run) {
    Figures figures;
    figures.is_stuck = run.deadlocked();
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        add_fifos(run, core, figures.hand_overs, true);
    if (figures.is_stuck) {
        figures.lines.push_back(fmt::format("deadlock at {}", run.deadlock_cycle()));
        for (StuckProcess const& one : run.stuck)
            figures.lines.push_back(wait_line(one.core, one.process, one.fifo, one.to_write, one.since_cycle,
                                              one.waits_for, one.occupancy));
        std::vector<std::string> fifos;
        for (std::size_t core = 0; core < run.cores.size(); ++core)
            add_fifos(run, core, fifos);
        figures.add_in_order(std::move(fifos));
        return figures;
    }
    figures.total_cycles = run.total_cycles;
    figures.lines.push_back(fmt::format("total {}", run.total_cycles));
    for (SampleStatistics const& sample : run.samples)
        figures.lines.push_back(sample_line(sample.sample, sample.start_cycle, sample.end_cycle));
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        add_tables(run, core, figures.lines);
    return figures;
}

void Figures::add_in_order(std::vector<std::string> fifos) {
    std::sort(fifos.begin(), fifos.end());
    lines.insert(lines.end(), fifos.begin(), fifos.end());
}

std::string first_difference(Figures const& found, Figures const& expected) {
    std::size_t const lines = std::max(found.lines.size(), expected.lines.size());
    for (std::size_t i = 0; i < lines; ++i) {
        std::string const left = i < found.lines.size() ? found.lines[i] : "nothing";
        std::string const right = i < expected.lines.size() ? expected.lines[i] : "nothing";
        if (left != right)
            return left + " against " + right;
    }
    return "";
}

}  // namespace faster::chance
