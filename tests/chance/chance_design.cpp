#include "chance/chance_design.hpp"

#include <algorithm>
#include <cstdlib>
#include <random>

#include "dataflow/core/machine/core_of.hpp"
#include "dataflow/run/config/calls.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::chance {

namespace {

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    std::uint64_t below(std::uint64_t end) { return random_() % end; }
    std::uint64_t between(std::uint64_t first, std::uint64_t last) { return first + below(last - first + 1); }
    bool one_in(std::uint64_t n) { return below(n) == 0; }

  private:
    std::mt19937_64 random_;
};

/// Number of a loop of a process; -1: by steps.
constexpr std::size_t by_steps = ~std::size_t{0};

class Maker {
  public:
    explicit Maker(std::uint64_t seed)
        : dice_(seed),
          dice_for_attempts_(~seed),
          dice_for_memory_(seed ^ 0x5A5A5A5A),
          dice_for_empty_(seed ^ 0x3C3C3C3C),
          dice_for_pace_(seed ^ 0x69696969),
          dice_for_described_(seed ^ 0x96969696),
          dice_for_idle_(seed ^ 0xC3C3C3C3) {}

    Design make() {
        add_processes();
        add_fifos();
        for (Process& process : design_.processes)
            add_loops(process);
        for (std::uint64_t phase = dice_.between(1, 3); phase > 0; --phase)
            add_phase();
        add_rests();
        design_.cores = dice_.one_in(4) ? 2 : 1;
        design_.samples = dice_.between(1, 3);
        let_rewind();
        if (dice_for_memory_.one_in(3))
            add_memory();
        for (Process& process : design_.processes)
            if (dice_for_empty_.one_in(5))
                add_empty_loop(process);
        if (!dice_for_pace_.one_in(3))
            set_pace();
        add_idle_samples();
        return design_;
    }

  private:
    void add_processes() {
        std::uint64_t const count = dice_.one_in(12) ? 1 : dice_.between(2, 8);
        for (std::uint64_t i = 0; i < count; ++i) {
            Process process;
            process.name = "p" + std::to_string(i);
            process.takes_early = dice_.one_in(2);
            process.tries_early = dice_for_attempts_.one_in(2);
            process.memory_ports = dice_.between(1, 3);
            process.program.push_back(wait(dice_.one_in(2) ? 1 : dice_.below(6)));
            process.starts = dice_.one_in(4) ? dice_.below(9) : 0;
            design_.processes.push_back(process);
        }
    }

    void add_fifos() {
        std::size_t const processes = design_.processes.size();
        std::uint64_t const count = processes == 1 ? 0 : dice_.between(processes - 1, processes + 2);
        bool const may_be_cyclic = dice_.one_in(3);
        bool const may_hand_over = dice_.one_in(3);
        bool const have_attempts = dice_for_attempts_.one_in(3);
        for (std::size_t f = 0; f < count; ++f) {
            Fifo fifo;
            fifo.writer = dice_.below(processes);
            fifo.reader = (fifo.writer + dice_.between(1, processes - 1)) % processes;
            if (!may_be_cyclic && fifo.writer > fifo.reader)
                std::swap(fifo.writer, fifo.reader);
            fifo.bits = dice_.one_in(2) ? 32 : static_cast<unsigned>(dice_.between(1, 300));
            fifo.write_stage = dice_.one_in(2) ? 0 : dice_.below(7);
            fifo.read_stage = dice_.one_in(2) ? 0 : dice_.below(5);
            set_room(fifo, dice_);
            if (dice_for_described_.one_in(2))
                fifo.described_depth = fifo.depth;
            fifo.is_ping_pong = may_hand_over && fifo.writer < fifo.reader && dice_.one_in(2);
            if (have_attempts && !fifo.is_ping_pong && dice_for_attempts_.one_in(2)) {
                fifo.writer_tries = dice_for_attempts_.one_in(2);
                fifo.reader_tries = fifo.writer_tries ? !dice_for_attempts_.one_in(5) : dice_for_attempts_.one_in(2);
            }
            design_.fifos.push_back(fifo);
        }
        // As a core lists them: by their writers.
        std::stable_sort(design_.fifos.begin(), design_.fifos.end(),
                         [](Fifo const& one, Fifo const& other) { return one.writer < other.writer; });
        for (std::size_t f = 0; f < count; ++f) {
            Fifo& fifo = design_.fifos[f];
            fifo.name = "f" + std::to_string(f);
            for (std::size_t const process : {fifo.writer, fifo.reader}) {
                Process& at = design_.processes[process];
                (fifo.is_ping_pong ? at.buffers : at.ends).push_back(f);
            }
        }
        for (std::size_t i = 0; i < processes; ++i)
            std::stable_partition(design_.processes[i].buffers.begin(), design_.processes[i].buffers.end(),
                                  [&](std::size_t fifo) { return design_.writes(i, fifo); });
        design_.calls = dice_.one_in(4) ? CallOrder::in_turn : CallOrder::overlapped;
        design_.rules = static_cast<FifoGeneration>(dice_.below(3));
    }

    void add_loops(Process& process) {
        for (std::uint64_t i = dice_.between(1, 2); i > 0; --i) {
            Loop loop;
            loop.name = "loop" + std::to_string(process.loops.size());
            set_pace(loop, dice_);
            if (dice_.one_in(4)) {
                loop.reads = static_cast<unsigned>(dice_.between(1, 4));
                loop.writes = static_cast<unsigned>(dice_.below(3));
            }
            process.loops.push_back(loop);
        }
        if (process.ends.empty() && dice_.one_in(2))
            process.loops.clear();
        std::size_t const number = static_cast<std::size_t>(&process - design_.processes.data());
        for (Loop& loop : process.loops) {
            Cycles deepest = 0;
            for (std::size_t const fifo : process.ends)
                deepest = std::max(deepest, design_.stage(number, fifo));
            loop.depth = deepest + dice_.between(1, 4);
            if (dice_.one_in(3)) {
                loop.is_pipelined = false;
                loop.entry = dice_.below(3);
                loop.exit = dice_.below(3);
            }
        }
    }

    /// Both ends of each FIFO that takes part access it equally often.
    void add_phase() {
        std::uint64_t const count = dice_.one_in(6) ? dice_.between(1, 200) : dice_.between(1, 15);
        std::vector<bool> takes_part;
        for (std::size_t f = 0; f < design_.fifos.size(); ++f)
            takes_part.push_back(!dice_.one_in(6));
        for (Process& process : design_.processes) {
            Accesses ports;
            for (std::size_t const fifo : process.ends)
                if (takes_part[fifo])
                    ports.push_back(fifo);
            std::size_t const loop =
                process.loops.empty() || dice_.one_in(6) ? by_steps : dice_.below(process.loops.size());
            if (loop != by_steps)
                add_loop(process, loop, iterations(ports, count));
            else
                for (Accesses const& step : iterations(ports, count))
                    add_step(process, step);
            if (dice_.one_in(2))
                process.program.push_back(wait(dice_.below(5)));
        }
    }

    /// What was written, and not found.
    void add_rests() {
        for (std::size_t f = 0; f < design_.fifos.size(); ++f) {
            Fifo const& fifo = design_.fifos[f];
            if (!fifo.reader_tries || fifo.writer_tries)
                continue;
            Segment rest;
            rest.kind = Segment::Kind::rest;
            rest.step = {f};
            design_.processes[fifo.reader].program.push_back(rest);
            design_.processes[fifo.reader].program.push_back(wait(1));
        }
    }

    /// Processes that are one loop, but for waiting, which some do all the same: those drain. Of the last one the end
    /// of a sample is only what is foreseen, unless nothing stops it.
    void let_rewind() {
        for (std::size_t i = 0; i < design_.processes.size(); ++i) {
            if (i > 0 && i + 1 == design_.processes.size())
                break;
            Process& process = design_.processes[i];
            std::vector<Segment> loops;
            for (Segment const& segment : process.program)
                if (segment.kind != Segment::Kind::wait)
                    loops.push_back(segment);
            bool const is_plain = std::none_of(process.ends.begin(), process.ends.end(), [&](std::size_t fifo) {
                return design_.tries(i, fifo) || (!design_.writes(i, fifo) && design_.fifos[fifo].read_stage > 0);
            });
            if (loops.size() != 1 || loops.front().kind != Segment::Kind::loop || !is_plain ||
                !process.buffers.empty() || !process.loops[loops.front().loop].is_pipelined)
                continue;
            Loop& loop = process.loops[loops.front().loop];
            loop.can_rewind = dice_for_memory_.one_in(2);
            loop.rewinds = loop.can_rewind;
            if (loop.can_rewind && !dice_for_idle_.one_in(6))
                process.program = loops;
        }
    }

    /// Without an iteration, anywhere among what a process does.
    void add_empty_loop(Process& process) {
        auto const is_something = [](Segment const& segment) { return segment.kind != Segment::Kind::wait; };
        bool const is_busy = std::any_of(process.program.begin(), process.program.end(), is_something);
        std::size_t const loop = process.loops.empty() ? 0 : dice_for_empty_.below(process.loops.size());
        if (!is_busy || process.loops.empty() || design_.rewinds(process) || process.port.loop == loop)
            return;
        Segment segment;
        segment.kind = Segment::Kind::loop;
        segment.loop = loop;
        std::uint64_t const at = dice_for_empty_.below(process.program.size() + 1);
        process.program.insert(process.program.begin() + static_cast<std::ptrdiff_t>(at), segment);
    }

    void add_memory() {
        set_memory(design_.memory, dice_for_memory_);
        for (Process& process : design_.processes) {
            if (dice_for_memory_.one_in(2) || (design_.processes.size() == 1 && design_.rewinds(process)))
                continue;
            MemoryPort& port = process.port;
            port.is_there = true;
            port.writes = dice_for_memory_.one_in(2);
            port.token_bytes = dice_for_memory_.one_in(2) ? 4 : dice_for_memory_.between(1, 40);
            port.address = dice_for_memory_.below(1U << 20U);
            if (!process.loops.empty() && !dice_for_memory_.one_in(4))
                port.loop = dice_for_memory_.below(process.loops.size());
            for (Segment& segment : process.program)
                access_memory(process, port, segment);
        }
    }
    /// A step that takes a token from memory reads no FIFO.
    void access_memory(Process const& process, MemoryPort const& port, Segment& segment) {
        bool const is_rare = dice_for_memory_.one_in(2);
        auto const number = static_cast<std::size_t>(&process - design_.processes.data());
        bool const may_step =
            port.writes || std::all_of(segment.step.begin(), segment.step.end(),
                                       [&](std::size_t fifo) { return design_.writes(number, fifo); });
        if (!port.loop && segment.kind == Segment::Kind::step && may_step)
            segment.at_memory.push_back(dice_for_memory_.one_in(2));
        for (std::size_t i = 0; port.loop && segment.loop == *port.loop && i < segment.iterations.size(); ++i)
            segment.at_memory.push_back(!is_rare || dice_for_memory_.one_in(2));
    }

    /// Who accesses FIFOs without waiting has none.
    void set_pace() {
        auto const is_tried = [](Fifo const& fifo) { return fifo.writer_tries || fifo.reader_tries; };
        if (std::any_of(design_.fifos.begin(), design_.fifos.end(), is_tried))
            return;
        design_.driver = dice_for_pace_.below(design_.processes.size());
        std::vector<bool> follows(design_.processes.size(), false);
        for (std::size_t f = 0; f < design_.fifos.size(); ++f) {
            Fifo const& fifo = design_.fifos[f];
            if (fifo.is_ping_pong || (fifo.writer != design_.driver && fifo.reader != design_.driver))
                continue;
            std::size_t const other = fifo.writer == design_.driver ? fifo.reader : fifo.writer;
            if (follows[other] || dice_for_pace_.one_in(5))
                continue;
            follows[other] = true;
            design_.anchors.push_back(f);
        }
    }

    /// One at least is not. Calls in turn and buffers are exchanged all the same, which is left out here. Mostly where
    /// a loop rewinds: tokens of a call stay in it then.
    void add_idle_samples() {
        bool const rewinds = std::any_of(design_.processes.begin(), design_.processes.end(),
                                         [this](Process const& process) { return design_.rewinds(process); });
        if (!dice_for_idle_.one_in(rewinds ? 2 : 8))
            return;
        bool const hands_over = std::any_of(design_.processes.begin(), design_.processes.end(),
                                            [](Process const& process) { return !process.buffers.empty(); });
        if (hands_over || design_.calls == CallOrder::in_turn)
            return;
        design_.samples = dice_for_idle_.between(2, 6);
        for (std::size_t i = 0; i < design_.samples; ++i)
            design_.idle_samples.push_back(dice_for_idle_.one_in(2));
        design_.idle_samples[dice_for_idle_.below(design_.samples)] = false;
    }

    void add_loop(Process& process, std::size_t loop, std::vector<Accesses> iterations) {
        Segment segment;
        segment.kind = Segment::Kind::loop;
        segment.loop = loop;
        segment.iterations = std::move(iterations);
        process.program.push_back(segment);
    }

    void add_step(Process& process, Accesses const& ports) {
        Segment segment = wait(1);
        if (!ports.empty()) {
            segment.kind = Segment::Kind::step;
            segment.step = ports;
        }
        process.program.push_back(segment);
        if (dice_.one_in(2))
            process.program.push_back(wait(1));
    }

    std::vector<Accesses> iterations(Accesses const& ports, std::uint64_t count) {
        std::vector<Accesses> all;
        if (ports.empty() || dice_.one_in(2)) {
            for (std::uint64_t i = 0; i < count; ++i) {
                all.push_back(ports);
                if (dice_.one_in(8))
                    all.resize(all.size() + dice_.below(3));
            }
            return all;
        }
        std::vector<std::uint64_t> left(ports.size(), count);
        while (std::any_of(left.begin(), left.end(), [](std::uint64_t n) { return n > 0; })) {
            Accesses iteration;
            for (std::size_t i = 0; i < ports.size(); ++i)
                if (left[i] > 0 && !dice_.one_in(4)) {
                    iteration.push_back(ports[i]);
                    --left[i];
                }
            all.push_back(iteration);
        }
        return all;
    }

    static Segment wait(Cycles cycles) {
        Segment segment;
        segment.cycles = cycles;
        return segment;
    }

  public:
    static void set_room(Fifo& fifo, Dice& dice) {
        fifo.depth = dice.one_in(2) ? dice.between(1, 4) : dice.between(3, 40);
        fifo.kind = dice.one_in(2) ? FifoKind::automatic : dice.one_in(2) ? FifoKind::shift_register : FifoKind::memory;
    }
    static void set_memory(ExternalMemorySettings& memory, Dice& dice) {
        memory.model = MemoryModel::axi;
        memory.ports = dice.between(1, 3);
        memory.port_bytes = 4U << dice.below(4);
        memory.burst_bytes = memory.port_bytes << dice.below(4);
        memory.outstanding = dice.between(1, 5);
        memory.request_cycles = dice.below(12);
        memory.read_latency_ns = static_cast<double>(dice.below(150));
        memory.dram_gb_per_s = dice.one_in(2) ? 20 : 1;
    }
    static void set_pace(Loop& loop, Dice& dice) {
        loop.ii = dice.one_in(2) ? 1 : dice.between(1, 5);
        loop.recurrence = dice.one_in(4) ? dice.between(1, 4) : 1;
    }

  private:
    Dice dice_;
    Dice dice_for_attempts_;
    Dice dice_for_memory_;
    Dice dice_for_empty_;
    Dice dice_for_pace_;
    Dice dice_for_described_;
    Dice dice_for_idle_;
    Design design_;
};

ModuleDescription module_of(Design const& design, std::size_t number) {
    Process const& process = design.processes[number];
    ModuleDescription module(process.name);
    for (std::size_t const f : process.ends) {
        Fifo const& fifo = design.fifos[f];
        FifoEnd& end = design.writes(number, f) ? module.writes_to(fifo.name) : module.reads_from(fifo.name);
        if (design.tries(number, f))
            end.non_blocking();
        if (!end.writes)
            end.taken(process.loops.front().name, fifo.read_stage);
        else
            end.carries("numbers")
                .of_bits(fifo.bits)
                .leaves(process.loops.front().name, fifo.write_stage)
                .of_depth(fifo.described_depth);
        if (fifo.writer_tries)
            end.keeps_tokens();
    }
    for (std::size_t const f : process.buffers) {
        Fifo const& fifo = design.fifos[f];
        if (design.writes(number, f))
            module.writes_to(fifo.name).carries("buffers").of_bits(fifo.bits).hands_over(16).of_depth(
                fifo.described_depth);
        else
            module.reads_from(fifo.name);
    }
    std::string const memory = "memory_of_" + process.name;
    bool uses_memory = false;
    for (Loop const& loop : process.loops) {
        LoopDescription& described = module.loop(loop.name).does("works").of_depth(loop.depth);
        if (!loop.is_pipelined)
            described.of_states(loop.depth).enters_in(loop.entry).leaves_in(loop.exit);
        if (loop.can_rewind)
            described.rewinds();
        std::vector<std::string> written, read;
        for (std::size_t const f : process.ends)
            (design.writes(number, f) ? written : read).push_back(design.fifos[f].name);
        described.writes_to(written).also_reads(read);
        if (loop.reads + loop.writes == 0)
            continue;
        uses_memory = true;
        AccessPattern pattern;
        for (unsigned i = 0; i < loop.reads; ++i)
            pattern.reads.push_back({0, static_cast<int>(i)});
        for (unsigned i = 0; i < loop.writes; ++i)
            pattern.writes.push_back({0, static_cast<int>(i)});
        described.accesses_memory(memory, pattern);
    }
    if (process.port.is_there) {
        StreamDescription& stream =
            process.port.writes ? module.stores(process.name + "_port") : module.fetches(process.name + "_port");
        if (process.port.loop)
            stream.taken_by(process.loops[*process.port.loop].name);
    }
    if (uses_memory)
        module.memory(memory).holds("numbers").of_words(16, 16, 32);
    return module;
}

}  // namespace

Design random_design(std::uint64_t seed) { return Maker(seed).make(); }

Design retimed(Design const& design, std::uint64_t seed) {
    Dice dice(seed), dice_for_memory(seed + 1);
    Design other = design;
    if (design.has_memory() && dice_for_memory.one_in(6))
        other.memory.model = MemoryModel::ideal;
    else if (design.has_memory())
        Maker::set_memory(other.memory, dice_for_memory);
    for (Fifo& fifo : other.fifos)
        if (dice.one_in(2))
            Maker::set_room(fifo, dice);
    for (Process& process : other.processes) {
        for (Loop& loop : process.loops)
            if (dice.one_in(2)) {
                Maker::set_pace(loop, dice);
                loop.entry = loop.is_pipelined ? 0 : dice.below(4);
            }
        for (Loop& loop : process.loops)
            loop.rewinds = loop.can_rewind && dice_for_memory.one_in(2);
        if (dice.one_in(4))
            process.starts = dice.below(9);
    }
    return other;
}

namespace {
/// A loop of its own, somewhere among what a process does.
void add_stores(Process& process, Dice& dice) {
    Loop loop = process.loops.front();
    loop.name = "stores";
    loop.is_pipelined = true;
    loop.ii = dice.between(1, 3);
    loop.recurrence = 1;
    loop.entry = loop.exit = loop.reads = loop.writes = 0;
    Segment segment;
    segment.kind = Segment::Kind::loop;
    segment.loop = process.loops.size();
    segment.iterations.resize(dice.between(1000, 2500));
    segment.at_memory.assign(segment.iterations.size(), true);
    process.port = {true, true, process.loops.size(), 64, 0};
    process.loops.push_back(loop);
    auto const at = static_cast<std::ptrdiff_t>(dice.below(process.program.size() + 1));
    process.program.insert(process.program.begin() + at, segment);
}
}  // namespace

Design storing_ahead(Design const& design, std::uint64_t seed) {
    Dice dice(seed);
    Design other = design;
    Maker::set_memory(other.memory, dice);
    other.memory.dram_gb_per_s = 0.5;
    for (Process& process : other.processes) {
        bool const may_rewind =
            std::any_of(process.loops.begin(), process.loops.end(), [](Loop const& loop) { return loop.can_rewind; });
        if (!process.port.is_there && !process.loops.empty() && !may_rewind && !dice.one_in(4))
            add_stores(process, dice);
    }
    return other;
}

namespace {
CoreDescription::Pace pace_of(Design const& design) {
    CoreDescription::Pace pace;
    if (design.anchors.empty())
        return pace;
    pace.driver = design.processes[design.driver].name;
    for (std::size_t const anchor : design.anchors) {
        Fifo const& fifo = design.fifos[anchor];
        std::size_t const follower = fifo.writer == design.driver ? fifo.reader : fifo.writer;
        pace.followers.push_back({design.processes[follower].name, fifo.name});
    }
    return pace;
}
}  // namespace

CoreDescription plain_description_of(Design const& design) {
    std::vector<ModuleDescription> modules;
    for (std::size_t i = 0; i < design.processes.size(); ++i)
        modules.push_back(module_of(design, i));
    CoreDescription core = core_of(modules);
    core.pace = pace_of(design);
    return core;
}

CoreDescription description_of(Design const& design) {
    return with_calls(plain_description_of(design), settings_of(design));
}

MachineSettings settings_of(Design const& design) {
    MachineSettings settings;
    settings.calls = design.calls;
    settings.cores = design.cores;
    settings.fifo_rules = design.rules;
    settings.external_memory = design.memory;
    for (Fifo const& fifo : design.fifos) {
        if (fifo.depth != fifo.described_depth)
            settings.fifo(fifo.name).depth = fifo.depth;
        settings.fifo(fifo.name).kind = fifo.kind;
    }
    for (Process const& process : design.processes) {
        settings.start(process.name) = process.starts;
        for (Loop const& loop : process.loops) {
            LoopSettings& of_loop = settings.loop(process.name + '.' + loop.name);
            if (!loop.is_pipelined) {
                of_loop.entry_states = loop.entry;
                of_loop.exit_states = loop.exit;
                continue;
            }
            of_loop.ii = loop.ii;
            of_loop.recurrence_ii = loop.recurrence;
            if (loop.can_rewind)
                of_loop.rewind = loop.rewinds;
            if (loop.reads + loop.writes > 0)
                settings.memory("memory_of_" + process.name).ports = process.memory_ports;
        }
    }
    return settings;
}

std::uint64_t accesses_of(Design const& design, std::size_t process, std::size_t fifo) {
    std::int64_t count = 0;
    for (Segment const& segment : design.processes[process].program) {
        if (segment.kind == Segment::Kind::step)
            count += std::count(segment.step.begin(), segment.step.end(), fifo);
        for (Accesses const& iteration : segment.iterations)
            count += std::count(iteration.begin(), iteration.end(), fifo);
    }
    return static_cast<std::uint64_t>(count);
}

std::uint64_t asked(char const* name, std::uint64_t otherwise) {
    char const* const text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

namespace {
std::string names_of(Design const& design, Accesses const& accesses) {
    std::string names;
    for (std::size_t const fifo : accesses)
        names += " " + design.fifos[fifo].name;
    return names;
}
}  // namespace

std::string text_of(Design const& design) {
    std::string text = std::to_string(design.cores) + " cores, " + std::to_string(design.samples) + " samples, rules " +
                       std::to_string(static_cast<int>(design.rules)) +
                       (design.calls == CallOrder::in_turn ? ", calls in turn" : "") +
                       (design.has_memory() ? ", memory of " + std::to_string(design.memory.ports) + " ports of " +
                                                  std::to_string(design.memory.port_bytes) + ", bursts of " +
                                                  std::to_string(design.memory.burst_bytes) + ", " +
                                                  std::to_string(design.memory.outstanding) + " outstanding\n"
                                            : "\n");
    for (std::size_t sample = 0; sample < design.idle_samples.size(); ++sample)
        text += design.is_idle(sample) ? "sample " + std::to_string(sample) + " is idle\n" : "";
    if (!design.anchors.empty())
        text += "paced by " + design.processes[design.driver].name + ", followed by way of" +
                names_of(design, design.anchors) + "\n";
    for (Fifo const& fifo : design.fifos)
        text += fifo.name + ": " + design.processes[fifo.writer].name + " (stage " + std::to_string(fifo.write_stage) +
                ") to " + design.processes[fifo.reader].name + " (stage " + std::to_string(fifo.read_stage) +
                "), depth " + std::to_string(fifo.depth) + " kind " + std::to_string(static_cast<int>(fifo.kind)) +
                " of " + std::to_string(fifo.bits) + (fifo.is_ping_pong ? " bits, ping-pong" : " bits") +
                (fifo.writer_tries ? ", writer tries" : "") + (fifo.reader_tries ? ", reader tries" : "") + "\n";
    auto const list = [&](Accesses const& accesses) { return names_of(design, accesses); };
    for (Process const& process : design.processes) {
        text +=
            process.name + (process.takes_early ? " (takes early)" : "") +
            (process.tries_early ? " (tries early):" : ":") + list(process.ends) + ", starts " +
            std::to_string(process.starts) + ", buffers" + list(process.buffers) +
            (process.port.is_there ? std::string(process.port.writes ? ", writes" : ", reads") + " memory by " +
                                         (process.port.loop ? "loop" + std::to_string(*process.port.loop) : "steps") +
                                         ", tokens of " + std::to_string(process.port.token_bytes)
                                   : "") +
            "\n";
        for (Loop const& loop : process.loops)
            text +=
                "  " + loop.name + ": II " + std::to_string(loop.ii) + ", recurrence " +
                std::to_string(loop.recurrence) + ", depth " + std::to_string(loop.depth) +
                (loop.is_pipelined ? ""
                                   : " states and " + std::to_string(loop.entry) + " + " + std::to_string(loop.exit)) +
                ", memory " + std::to_string(loop.reads) + " + " + std::to_string(loop.writes) + " on " +
                std::to_string(process.memory_ports) + (loop.rewinds ? ", rewinds\n" : "\n");
        for (Segment const& segment : process.program)
            text += segment.kind == Segment::Kind::wait   ? "  wait " + std::to_string(segment.cycles) + "\n"
                    : segment.kind == Segment::Kind::rest ? "  rest" + list(segment.step) + "\n"
                    : segment.kind == Segment::Kind::step
                        ? "  step" + list(segment.step) + "\n"
                        : "  run loop" + std::to_string(segment.loop) + " " +
                              std::to_string(segment.iterations.size()) + " times" +
                              (segment.iterations.empty() ? "" : ", first" + list(segment.iterations.front())) + "\n";
    }
    return text;
}

}  // namespace faster::chance
