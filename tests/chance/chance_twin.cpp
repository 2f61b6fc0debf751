#include "chance/chance_twin.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <utility>

#include "support/memory_twin.hpp"

namespace faster::chance {

namespace {

/// One cycle of a process, unless it has to wait in front of it.
struct Step {
    Accesses accesses;                  ///< in program order
    Accesses attempts;                  ///< that take place if they can
    std::optional<std::size_t> rest;    ///< a FIFO: not once, but as long as there has not been read
    std::uint64_t rest_until = 0;       ///< so much of it
    std::optional<std::size_t> begins;  ///< the first step of this sample of the core,
    Cycles begins_before = 0;           ///< or so many steps behind it
    std::optional<std::size_t> calls;   ///< the first of what the process does in it, behind its start
    std::optional<std::size_t> ends;    ///< the last
    std::optional<std::size_t> enters;  ///< an entry of the external memory
    std::optional<std::pair<std::size_t, std::size_t>> token;  ///< of an entry, that it takes or gives
};
using Steps = std::vector<Step>;

/// What a process does, and what it has to do with the external memory.
struct Program {
    Steps steps;
    std::vector<testing::TwinRanges> entries;
};

Cycles interval_of(Process const& process, Loop const& loop) {
    if (!loop.is_pipelined)
        return loop.depth;
    Cycles const of_ports = (loop.reads + loop.writes + process.memory_ports - 1) / process.memory_ports;
    return std::max({loop.ii, loop.recurrence, of_ports});
}

/// Appends all of a loop whose first iteration begins at a step, and returns the step in which another might begin.
std::size_t append_loop(Design const& design, std::size_t number, Segment const& segment, std::size_t begin,
                        Steps& steps) {
    Process const& process = design.processes[number];
    Loop const& loop = process.loops[segment.loop];
    Cycles const interval = interval_of(process, loop);
    if (segment.iterations.empty()) {
        steps.resize(begin + loop.exit);
        return begin;
    }
    steps.resize(std::max(steps.size(), begin + (segment.iterations.size() - 1) * interval + loop.depth + loop.exit));
    for (std::size_t i = 0; i < segment.iterations.size(); ++i)
        for (std::size_t const fifo : segment.iterations[i]) {
            Step& step = steps.at(begin + i * interval + design.stage(number, fifo));
            (design.tries(number, fifo) ? step.attempts : step.accesses).push_back(fifo);
        }
    return begin + segment.iterations.size() * interval;
}

void append_step(Design const& design, std::size_t number, Accesses const& accesses, Steps& steps) {
    steps.emplace_back();
    for (std::size_t const fifo : accesses)
        (design.tries(number, fifo) ? steps.back().attempts : steps.back().accesses).push_back(fifo);
}

void append_rest(std::size_t fifo, std::uint64_t until, Steps& steps) {
    steps.emplace_back();
    steps.back().accesses = {fifo};
    steps.back().rest = fifo;
    steps.back().rest_until = until;
}

/// A loop comes to an entry when it is entered, `entry` states before its first iteration; a step to one of its own.
void mark_memory(Design const& design, std::size_t number, std::size_t sample, Segment const& segment,
                 std::size_t begin, Program& program) {
    Process const& process = design.processes[number];
    bool const is_loop = segment.kind == Segment::Kind::loop;
    bool const is_there = design.has_memory() && process.port.is_there &&
                          (is_loop ? process.port.loop == segment.loop : segment.tokens() > 0);
    if (!is_there)
        return;
    testing::TwinRange const range{
        process.port.address_of(sample, static_cast<std::size_t>(&segment - process.program.data())),
        std::vector<std::uint64_t>(segment.tokens(), process.port.token_bytes)};
    std::size_t const entry = program.entries.size();
    program.entries.push_back({range});
    Loop const* const loop = is_loop ? &process.loops[segment.loop] : nullptr;
    if (!process.port.writes)
        program.steps.at(begin - (is_loop ? loop->entry : 0)).enters = entry;
    std::size_t token = 0;
    for (std::size_t i = 0; i < segment.at_memory.size(); ++i)
        if (segment.at_memory[i]) {
            std::size_t const of_iteration = is_loop ? i * interval_of(process, *loop) : 0;
            program.steps.at(begin + of_iteration + (is_loop && process.port.writes ? loop->depth - 1 : 0)).token = {
                entry, token++};
        }
}

/// Of all accesses that an iteration may make.
Cycles first_stage(Design const& design, std::size_t number, std::size_t loop) {
    Process const& process = design.processes[number];
    Cycles first = process.loops[loop].depth;
    for (std::size_t const fifo : process.ends)
        first = std::min(first, design.stage(number, fifo));
    bool const uses_memory = design.has_memory() && process.port.is_there && process.port.loop == loop;
    if (uses_memory)
        first = std::min(first, process.port.writes ? process.loops[loop].depth - 1 : 0);
    return first == process.loops[loop].depth ? 0 : first;
}

/// `first`: sample of the run that the core begins with.
Program program_of(Design const& design, std::size_t number, std::size_t first, std::size_t samples) {
    Process const& process = design.processes[number];
    Program program;
    Steps& steps = program.steps;
    std::size_t next = 0;  // step of the next iteration, of a process that rewinds
    std::size_t busy = 0;  // samples that are not idle
    for (std::size_t sample = 0; sample < samples; ++sample) {
        bool const goes_on = design.rewinds(process) && busy > 0;
        std::size_t const begin = goes_on ? next : steps.size();
        if (!goes_on)
            steps.resize(begin + (sample == 0 || design.calls == CallOrder::in_turn ? process.starts : 0));
        if (design.is_idle(first + sample))
            continue;
        ++busy;
        std::size_t const call = goes_on ? next : steps.size();
        for (Segment const& segment : process.program) {
            std::size_t at = goes_on ? next : steps.size();
            if (segment.kind == Segment::Kind::wait)
                steps.resize(steps.size() + segment.cycles);
            else if (segment.kind == Segment::Kind::step)
                append_step(design, number, segment.step, steps);
            else if (segment.kind == Segment::Kind::rest)
                append_rest(segment.step.front(), busy * accesses_of(design, number, segment.step.front()), steps);
            else {
                at += process.loops[segment.loop].entry;
                next = append_loop(design, number, segment, at, steps);
            }
            mark_memory(design, number, first + sample, segment, at, program);
        }
        Cycles const before = goes_on ? first_stage(design, number, process.program.front().loop) : 0;
        steps[begin + before].begins = sample;
        steps[begin + before].begins_before = before;
        steps[call].calls = sample;
        steps.back().ends = sample;
    }
    auto const place = [&](std::size_t fifo) {
        return std::find(process.ends.begin(), process.ends.end(), fifo) - process.ends.begin();
    };
    for (Step& step : steps)
        std::sort(step.accesses.begin(), step.accesses.end(),
                  [&](std::size_t one, std::size_t other) { return place(one) < place(other); });
    return program;
}

class CoreSimulation {
  public:
    struct OfFifo {
        std::uint64_t room = 0;
        Cycles latency = 1;
        std::vector<Cycles> written, read;
        Cycles full = 0, empty = 0;
        std::uint64_t most = 0;
        std::uint64_t holds() const { return written.size() - read.size(); }
    };
    struct OfProcess {
        Steps steps;
        std::size_t next = 0;
        Cycles arrived = 0;      ///< at the step to come
        Cycles handed_over = 0;  ///< when the call to begin, or begun last, was given its buffers
        Cycles end = 0;
        bool is_handed_over = false;
        bool has_accessed = false;
        Cycles empty = 0, full = 0, idle = 0;
        std::map<std::size_t, Cycles> waited;  ///< in the step at hand, by FIFO
        std::vector<Cycles> begins, ends;
        std::vector<std::string> outcomes;  ///< of attempts, by FIFO
        std::optional<std::size_t> master;  ///< in the memory
        Cycles memory = 0;
        bool is_done() const { return next == steps.size(); }
    };

    /// `memory`: null if there is none.
    CoreSimulation(Design const& design, std::size_t number, std::size_t first, std::size_t samples,
                   testing::TwinMemoryModel* memory)
        : design_(design), memory_(memory) {
        for (Fifo const& fifo : design.fifos) {
            bool const is_small = design.rules != FifoGeneration::spec && fifo.depth * fifo.bits <= 1024;
            bool const is_memory =
                fifo.kind == FifoKind::memory || (fifo.kind == FifoKind::automatic && fifo.depth > 2 && !is_small);
            bool const has_register = is_memory && design.rules != FifoGeneration::vitis_hls;
            OfFifo of_fifo;
            of_fifo.room = fifo.depth + (has_register ? 1 : 0);
            of_fifo.latency = is_memory ? 2 : 1;
            fifos.push_back(of_fifo);
        }
        for (std::size_t i = 0; i < design.processes.size(); ++i) {
            OfProcess process;
            Program program = program_of(design, i, first, samples);
            process.steps = std::move(program.steps);
            process.outcomes.resize(fifos.size());
            if (memory_ != nullptr && design.processes[i].port.is_there) {
                process.master = memory_->add_master(number % design.memory.ports, design.processes[i].port.writes);
                for (testing::TwinRanges const& ranges : program.entries)
                    memory_->master(*process.master).add_entry(ranges);
            }
            process.has_accessed = design.calls == CallOrder::in_turn && design.processes.size() > 1;
            processes.push_back(process);
        }
    }

    bool is_done() const {
        return std::all_of(processes.begin(), processes.end(), [](OfProcess const& one) { return one.is_done(); });
    }
    /// Who may step is decided before anybody does. False: nothing moves, nor will it unless the memory answers.
    bool pass_cycle(Cycles cycle) {
        cycle_ = cycle;
        for (OfProcess& process : processes)
            leave_rests(process);
        std::vector<std::size_t> movers;
        for (std::size_t i = 0; i < processes.size(); ++i)
            if (!processes[i].is_done() && may_step(i))
                movers.push_back(i);
        for (std::size_t const i : movers)
            step(i);
        for (OfFifo& fifo : fifos)
            fifo.most = std::max(fifo.most, fifo.holds());
        return !movers.empty() || something_ripens();
    }

    std::vector<OfFifo> fifos;
    std::vector<OfProcess> processes;
    bool is_stuck = false;

    /// What a process waits for whose call is to begin: the wait, as deadlocks tell of it.
    struct HandOver {
        std::string fifo;
        bool writes;
        std::size_t other;
        std::uint64_t holds;
    };
    std::optional<HandOver> hand_over_awaited(std::size_t number) const {
        if (std::optional<HandOver> const turn = turn_awaited(number))
            return turn;
        std::vector<HandOver> const awaited = buffers_awaited(number);
        return awaited.empty() ? std::nullopt : std::optional<HandOver>(awaited.front());
    }
    /// The one that is named: of several buffers one that it reads, if there is any.
    std::optional<HandOver> hand_over_named(std::size_t number) const {
        if (!turn_awaited(number))
            for (HandOver const& awaited : buffers_awaited(number))
                if (!awaited.writes)
                    return awaited;
        return hand_over_awaited(number);
    }
    /// When a process got to the step to come: not before the call of all begins that it is part of.
    Cycles arrival(std::size_t number) const {
        OfProcess const& process = processes[number];
        std::optional<std::size_t> const sample = process.steps[process.next].begins;
        bool const is_begun = std::all_of(processes.begin(), processes.end(), [&](OfProcess const& other) {
            return sample && other.ends.size() >= *sample;
        });
        Cycles arrived = process.arrived;
        for (OfProcess const& other : processes)
            if (is_begun && *sample > 0 && design_.calls == CallOrder::in_turn)
                arrived = std::max(arrived, other.ends[*sample - 1] + 1);
        return arrived;
    }

    Cycles waits_since(std::size_t number) const {
        OfProcess const& process = processes[number];
        return process.is_handed_over ? std::max(arrival(number), process.handed_over) : arrival(number);
    }

    bool may_access(std::size_t process, std::size_t number) const {
        OfFifo const& fifo = fifos[number];
        if (!design_.writes(process, number))
            return fifo.written.size() > fifo.read.size() && fifo.written[fifo.read.size()] + fifo.latency <= cycle_;
        std::size_t const place = fifo.written.size();
        return place < fifo.room ||
               (place - fifo.room < fifo.read.size() && fifo.read[place - fifo.room] + 1 <= cycle_);
    }

  private:
    std::optional<HandOver> turn_awaited(std::size_t number) const {
        Step const& step = processes[number].steps[processes[number].next];
        if (step.begins && design_.calls == CallOrder::in_turn)
            for (std::size_t i = 0; i < processes.size(); ++i)
                if (processes[i].ends.size() < *step.begins)
                    return number == 0 && i > 0 ? HandOver{design_.processes[i].name + "_ends", true, i, 1}
                                                : HandOver{design_.processes[number].name + "_begins", false, 0, 0};
        return std::nullopt;
    }
    /// In program order.
    std::vector<HandOver> buffers_awaited(std::size_t number) const {
        Step const& step = processes[number].steps[processes[number].next];
        std::vector<HandOver> awaited;
        for (std::size_t const buffer : step.calls ? design_.processes[number].buffers : Accesses()) {
            Fifo const& fifo = design_.fifos[buffer];
            if (fifo.writer == number && *step.calls >= processes[fifo.reader].ends.size() + fifo.depth)
                awaited.push_back({fifo.name, true, fifo.reader, fifo.depth});
            if (fifo.reader == number && *step.calls >= processes[fifo.writer].ends.size())
                awaited.push_back({fifo.name + "_filled", false, fifo.writer, 0});
        }
        return awaited;
    }

    void leave_rests(OfProcess& process) const {
        while (!process.is_done() && process.steps[process.next].rest &&
               fifos[*process.steps[process.next].rest].read.size() >= process.steps[process.next].rest_until)
            ++process.next;
    }

    bool may_step(std::size_t number) {
        OfProcess& process = processes[number];
        bool const is_first = !process.has_accessed && process.next == 0;
        if (auto const awaited = hand_over_awaited(number); awaited) {
            ++(is_first ? process.idle : awaited->writes ? process.full : process.empty);
            return false;
        }
        if (process.steps[process.next].calls && !design_.processes[number].buffers.empty()) {
            process.has_accessed = true;
            process.handed_over = std::exchange(process.is_handed_over, true) ? process.handed_over : cycle_;
        }
        Step& step = process.steps[process.next];
        if (step.enters && process.master)
            memory_->master(*process.master).begin_entry(*std::exchange(step.enters, std::nullopt), cycle_);
        bool const takes = step.token && process.master && !design_.processes[number].port.writes;
        if (takes &&
            memory_->master(*process.master).token_legal_from(step.token->first, step.token->second) > cycle_) {
            ++process.memory;
            return false;
        }
        for (std::size_t const fifo : process.steps[process.next].accesses) {
            if (may_access(number, fifo))
                continue;
            bool const writes = design_.writes(number, fifo);
            ++process.waited[fifo];
            bool const is_idle = !process.has_accessed && process.next == 0 && !takes;
            ++(is_idle ? process.idle : writes ? process.full : process.empty);
            return false;
        }
        return true;
    }

    void step(std::size_t number) {
        OfProcess& process = processes[number];
        Cycles const arrived = arrival(number);
        Step const& step = process.steps[process.next];
        process.next += step.rest ? 0U : 1U;
        process.is_handed_over = false;
        for (auto const& [fifo, cycles] : std::exchange(process.waited, {}))
            (design_.writes(number, fifo) ? fifos[fifo].full : fifos[fifo].empty) += cycles;
        if (step.token && process.master) {
            testing::TwinMasterModel& master = memory_->master(*process.master);
            design_.processes[number].port.writes ? master.give(step.token->first, step.token->second, cycle_ + 1)
                                                  : master.take(step.token->first, step.token->second, cycle_);
            process.has_accessed = true;
        }
        for (std::size_t const fifo : step.accesses)
            access(number, fifo);
        for (std::size_t const fifo : step.attempts) {
            bool const is_found = may_access(number, fifo);
            process.outcomes[fifo] += is_found ? '+' : '-';
            if (is_found)
                access(number, fifo);
        }
        // A sample begins when the process gets to its first step, and waits there.
        if (step.begins)
            process.begins.push_back(arrived - step.begins_before);
        if (step.ends)
            process.ends.push_back(cycle_);
        process.arrived = process.end = cycle_ + 1;
    }

    void access(std::size_t number, std::size_t fifo) {
        (design_.writes(number, fifo) ? fifos[fifo].written : fifos[fifo].read).push_back(cycle_);
        processes[number].has_accessed = true;
    }

    bool something_ripens() const {
        for (OfProcess const& process : processes) {
            std::optional<std::pair<std::size_t, std::size_t>> const token =
                process.is_done() || !process.master ? std::nullopt : process.steps[process.next].token;
            Cycles const from =
                token ? memory_->master(*process.master).token_legal_from(token->first, token->second) : 0;
            if (from > cycle_ && from != testing::TwinMasterModel::never)
                return true;
        }
        return std::any_of(fifos.begin(), fifos.end(), [this](OfFifo const& fifo) {
            bool const token = !fifo.written.empty() && fifo.written.back() + fifo.latency > cycle_;
            return token || (!fifo.read.empty() && fifo.read.back() + 1 > cycle_);
        });
    }

    Design const& design_;
    testing::TwinMemoryModel* memory_;
    Cycles cycle_ = 0;
};

testing::TwinMemory memory_of(Design const& design) {
    testing::TwinMemory memory;
    memory.is_axi = true;
    memory.ports = design.memory.ports;
    memory.port_bytes = design.memory.port_bytes;
    memory.burst_bytes = design.memory.burst_bytes;
    memory.outstanding = design.memory.outstanding;
    memory.request_cycles = design.memory.request_cycles;
    memory.read_latency_ns = design.memory.read_latency_ns;
    memory.dram_gb_per_s = design.memory.dram_gb_per_s;
    memory.dram_efficiency = design.memory.dram_efficiency;
    return memory;
}

/// The cores share nothing but the memory.
void run(std::vector<CoreSimulation>& cores, testing::TwinMemoryModel* memory) {
    for (Cycles cycle = 0;; ++cycle) {
        bool is_over = true, moves = false;
        for (CoreSimulation& core : cores)
            if (!core.is_done()) {
                is_over = false;
                moves = core.pass_cycle(cycle) || moves;
            }
        bool const asks = memory != nullptr && !memory->is_idle();
        if (memory != nullptr)
            memory->end_cycle(cycle);
        if (is_over)
            return;
        if (!moves && !asks)
            break;
    }
    for (CoreSimulation& core : cores)
        core.is_stuck = !core.is_done();
}

/// Of a process that cannot go on: the first FIFO that it cannot read in the step at hand, or else the first that it
/// cannot write.
std::size_t missing(Design const& design, CoreSimulation const& core, std::size_t number) {
    CoreSimulation::OfProcess const& process = core.processes[number];
    Accesses empty, full;
    for (std::size_t const fifo : process.steps[process.next].accesses)
        if (!core.may_access(number, fifo))
            (design.writes(number, fifo) ? full : empty).push_back(fifo);
    return (empty.empty() ? full : empty).at(0);
}

void add_waits(Design const& design, std::size_t core, CoreSimulation const& simulation, Figures& figures,
               Cycles& latest) {
    for (std::size_t i = 0; i < simulation.processes.size(); ++i) {
        CoreSimulation::OfProcess const& process = simulation.processes[i];
        if (process.is_done())
            continue;
        Cycles const since = simulation.waits_since(i);
        std::string const& name = design.processes[i].name;
        if (auto const awaited = simulation.hand_over_named(i); awaited) {
            figures.lines.push_back(wait_line(core, name, awaited->fifo, awaited->writes, since,
                                              design.processes[awaited->other].name, awaited->holds));
        } else {
            std::size_t const number = missing(design, simulation, i);
            Fifo const& fifo = design.fifos[number];
            bool const writes = design.writes(i, number);
            figures.lines.push_back(wait_line(core, name, fifo.name, writes, since,
                                              design.processes[writes ? fifo.reader : fifo.writer].name,
                                              simulation.fifos[number].holds()));
        }
        latest = std::max(latest, since);
    }
}

/// An idle sample begins when the first process gets to what it does next, and ends when the last one is done with what
/// it did before. `begin`, `end`: of the core's samples.
void add_samples(Design const& design, CoreSimulation const& core, std::size_t begin, std::size_t end,
                 Figures& figures) {
    std::vector<Cycles> const& begins = core.processes.front().begins;
    std::vector<Cycles> const& ends = core.processes.back().ends;
    Cycles const starts = design.processes.back().starts;
    std::size_t busy = 0;
    for (std::size_t sample = begin; sample < end; ++sample) {
        bool const starts_it_all = sample == begin && design.is_idle(sample);
        Cycles const began = busy < begins.size() ? begins[busy] : core.processes.front().end;
        busy += design.is_idle(sample) ? 0U : 1U;
        Cycles const before = starts > 0 ? starts - 1 : 0;
        figures.lines.push_back(sample_line(sample, starts_it_all ? 0 : began, busy > 0 ? ends[busy - 1] : before));
    }
}

void add_fifos(Design const& design, std::size_t core, CoreSimulation const& simulation,
               std::vector<std::string>& lines) {
    for (std::size_t i = 0; i < design.fifos.size(); ++i) {
        if (design.fifos[i].is_ping_pong)
            continue;
        CoreSimulation::OfFifo const& fifo = simulation.fifos[i];
        lines.push_back(fifo_line(core, design.fifos[i].name, fifo.written.size(), fifo.read.size(), fifo.full,
                                  fifo.empty, fifo.most));
    }
}

void add_tables(Design const& design, std::size_t core, CoreSimulation const& simulation, std::size_t samples,
                Cycles total, Figures& figures) {
    add_fifos(design, core, simulation, figures.lines);
    for (Process const& process : design.processes)
        for (std::size_t i = 0; i < process.loops.size(); ++i) {
            std::uint64_t entries = 0, iterations = 0;
            for (Segment const& segment : process.program)
                if (segment.kind == Segment::Kind::loop && segment.loop == i && !segment.iterations.empty()) {
                    entries += design.rewinds(process) ? std::min<std::size_t>(samples, 1) : samples;
                    iterations += samples * segment.iterations.size();
                }
            figures.lines.push_back(loop_line(core, process.name + '.' + process.loops[i].name,
                                              interval_of(process, process.loops[i]), entries, iterations));
        }
    for (std::size_t i = 0; i < design.processes.size(); ++i) {
        CoreSimulation::OfProcess const& process = simulation.processes[i];
        figures.lines.push_back(process_line(core, design.processes[i].name, process.memory, process.empty,
                                             process.full, process.idle, total - process.end));
    }
}

}  // namespace

Figures simulated(Design const& design) {
    std::optional<testing::TwinMemoryModel> memory;
    if (design.has_memory())
        memory.emplace(memory_of(design), MachineSettings().clock_mhz);
    std::vector<CoreSimulation> cores;
    std::vector<std::size_t> shares;
    std::size_t const largest = (design.samples + design.cores - 1) / design.cores;
    for (std::size_t core = 0; core < design.cores; ++core) {
        std::size_t const first = std::min(core * largest, design.samples);
        shares.push_back(std::min(largest, design.samples - first));
        cores.emplace_back(design, core, first, shares.back(), memory ? &*memory : nullptr);
    }
    run(cores, memory ? &*memory : nullptr);
    Figures figures;
    Cycles latest = 0, total = 0;
    for (std::size_t core = 0; core < cores.size(); ++core) {
        figures.is_stuck = figures.is_stuck || cores[core].is_stuck;
        if (cores[core].is_stuck)
            add_waits(design, core, cores[core], figures, latest);
        for (CoreSimulation::OfProcess const& process : cores[core].processes) {
            total = std::max(total, process.end);
            figures.outcomes.insert(figures.outcomes.end(), process.outcomes.begin(), process.outcomes.end());
        }
    }
    if (figures.is_stuck) {
        figures.lines.insert(figures.lines.begin(), fmt::format("deadlock at {}", latest));
        std::vector<std::string> fifos;
        for (std::size_t core = 0; core < cores.size(); ++core)
            add_fifos(design, core, cores[core], fifos);
        figures.add_in_order(std::move(fifos));
        return figures;
    }
    figures.lines.push_back(fmt::format("total {}", total));
    std::size_t first = 0;
    for (std::size_t core = 0; core < cores.size(); first += shares[core++])
        add_samples(design, cores[core], first, first + shares[core], figures);
    for (std::size_t core = 0; core < cores.size(); ++core)
        add_tables(design, core, cores[core], cores[core].processes.front().begins.size(), total, figures);
    return figures;
}

}  // namespace faster::chance
