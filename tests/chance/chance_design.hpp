#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/machine/machine_settings.hpp"
#include "dataflow/core/machine/module_description.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::chance {

/// A design by chance, as data: what its modules do, and with what timing.

struct Fifo {
    std::string name;
    std::size_t writer = 0;  ///< numbers of processes
    std::size_t reader = 0;
    std::uint64_t depth = 2;
    std::uint64_t described_depth = 2;  ///< the depth without a key
    FifoKind kind = FifoKind::automatic;
    unsigned bits = 32;
    Cycles write_stage = 0;
    Cycles read_stage = 0;
    bool is_ping_pong = false;  ///< `depth` buffers that calls hand over, and no FIFO
    bool writer_tries = false;  ///< writes without waiting, and drops what finds no room
    bool reader_tries = false;  ///< reads without waiting
};

/// By number of a FIFO.
using Accesses = std::vector<std::size_t>;

struct Loop {
    std::string name;
    Cycles ii = 1;          ///< asked for
    Cycles recurrence = 1;  ///< demanded
    Cycles depth = 1;
    bool is_pipelined = true;  ///< otherwise, `depth` states, and those around:
    Cycles entry = 0, exit = 0;
    unsigned reads = 0, writes = 0;  ///< of the process's memory, per iteration
    bool can_rewind = false, rewinds = false;
};

/// Some cycles, one step, or all of a loop: an iteration for each list of accesses. Or a read a cycle of what is left
/// of a sample in a FIFO that is read without waiting.
struct Segment {
    enum class Kind { wait, step, loop, rest } kind = Kind::wait;
    Cycles cycles = 0;
    Accesses step;
    std::size_t loop = 0;
    std::vector<Accesses> iterations;
    std::vector<bool> at_memory;  ///< whether each iteration, or the step, accesses the external memory
    bool is_at_memory(std::size_t i) const { return i < at_memory.size() && at_memory[i]; }
    std::uint64_t tokens() const {
        return static_cast<std::uint64_t>(std::count(at_memory.begin(), at_memory.end(), true));
    }
};

/// A process's port to the external memory.
struct MemoryPort {
    bool is_there = false, writes = false;
    std::optional<std::size_t> loop;  ///< none: steps access it
    std::uint64_t token_bytes = 1;
    std::uint64_t address = 0;

    /// Of the i-th token of a sample's n-th loop or step: anywhere.
    std::uint64_t address_of(std::size_t sample, std::size_t segment) const {
        return address + (97 * sample + 1313 * segment) % 4099;
    }
};

struct Process {
    std::string name;
    Accesses ends;     ///< FIFOs in the program order of a step
    Accesses buffers;  ///< ping-pong buffers, written ones first
    Cycles starts = 0;
    std::vector<Loop> loops;
    std::uint64_t memory_ports = 2;
    MemoryPort port;
    std::vector<Segment> program;  ///< of every sample that is not idle
    bool takes_early = false;      ///< reads by plain ports where that is allowed
    bool tries_early = false;      ///< in the body of an iteration, where that is allowed

    /// Its loops go on until the module says otherwise, which might be by what they access late.
    bool decides_trip_counts() const { return ends.size() % 4 == 3; }
};

struct Design {
    std::vector<Fifo> fifos;
    std::vector<Process> processes;
    FifoGeneration rules = FifoGeneration::vitis_hls;
    CallOrder calls = CallOrder::overlapped;
    ExternalMemorySettings memory;
    /// Who sets the pace, and by which FIFOs others follow it, if any do. No cycle depends on it.
    std::size_t driver = 0;
    Accesses anchors;
    std::uint64_t cores = 1;
    std::size_t samples = 1;
    std::vector<bool> idle_samples;  ///< for which no process does anything; empty: none

    bool writes(std::size_t process, std::size_t fifo) const { return fifos[fifo].writer == process; }
    bool tries(std::size_t process, std::size_t fifo) const {
        return writes(process, fifo) ? fifos[fifo].writer_tries : fifos[fifo].reader_tries;
    }
    bool is_idle(std::size_t sample) const { return !idle_samples.empty() && idle_samples[sample]; }
    bool has_memory() const { return memory.model == MemoryModel::axi; }
    /// Calls of a process are one loop after the other, without a gap.
    bool rewinds(Process const& process) const {
        return calls == CallOrder::overlapped && process.program.size() == 1 &&
               process.program.front().kind == Segment::Kind::loop &&
               process.loops[process.program.front().loop].rewinds;
    }
    Cycles stage(std::size_t process, std::size_t fifo) const {
        return writes(process, fifo) ? fifos[fifo].write_stage : fifos[fifo].read_stage;
    }
};

/// A seed always gives one design.
Design random_design(std::uint64_t seed);
/// With processes that store many tokens in a row, faster than the memory takes them.
Design storing_ahead(Design const& design, std::uint64_t seed);
/// What a design is at other timing keys.
Design retimed(Design const& design, std::uint64_t seed);

/// As the kernel is told of it: by its user, and with what calls hand over.
CoreDescription plain_description_of(Design const& design);
CoreDescription description_of(Design const& design);
MachineSettings settings_of(Design const& design);

/// What a process does at a FIFO in a sample, found or not.
std::uint64_t accesses_of(Design const& design, std::size_t process, std::size_t fifo);

/// What the environment asks for: CHANCE_SEED, the first, and CHANCE_DESIGNS, how many.
std::uint64_t asked(char const* name, std::uint64_t otherwise);

/// For people, to see a failure by.
std::string text_of(Design const& design);

}  // namespace faster::chance
