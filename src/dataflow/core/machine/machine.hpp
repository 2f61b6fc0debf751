#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/base/device/block_ram.hpp"
#include "dataflow/core/machine/bank_partition.hpp"
#include "dataflow/core/machine/machine_settings.hpp"
#include "dataflow/core/machine/module_description.hpp"
#include "dataflow/core/memory/external_memory.hpp"
#include "dataflow/core/memory/memory_stream.hpp"
#include "dataflow/core/memory/memory_system.hpp"
#include "dataflow/core/time/fifo_timing.hpp"
#include "dataflow/core/time/initiation_interval.hpp"
#include "dataflow/core/time/lead.hpp"
#include "dataflow/core/time/process_timing.hpp"

namespace dataflow {

/// Parts of a machine have numbers, which are the same whatever parts a configuration has: a part that is not there
/// keeps its number.

/// What a process does with one of its FIFOs: reads it, or writes it.
struct MachineEnd {
    std::size_t fifo = 0;  ///< number of a FIFO
    bool writes = false;
    FifoEnd::When when = FifoEnd::When::within_call;
    bool makes_attempts = false;  ///< may access it without waiting
};

struct MachineProcess {
    std::string name;
    bool is_present = true;
    std::string decided_by;  ///< key that takes it away, if it is not there
    bool stamps_look_back = false;
    timing::CallStart call_start;
    Cycles setup_cycles = 0;
    std::string setup_activity;                                 ///< "preparing rows", for reports
    std::optional<std::size_t> setup_counter;                   ///< FIFO with a write for every setup
    std::map<std::string, std::uint64_t, std::less<>> numbers;  ///< that decide what it does
    std::vector<MachineEnd> ends;    ///< of the FIFOs that are there, in the program order of a step
    std::vector<std::size_t> loops;  ///< numbers of those that are there, in order
    SourceSite described_at;         ///< no file: nobody knows
};

struct MachineFifo {
    std::string name;
    bool is_present = true;
    std::string decided_by;
    std::size_t writer = 0;  ///< numbers of processes
    std::size_t reader = 0;
    FifoKind configured_kind = FifoKind::automatic;
    FifoKind kind = FifoKind::shift_register;  ///< resolved
    FifoGeneration generation = FifoGeneration::vitis_hls;
    std::uint64_t depth = 2;  ///< tokens
    Cycles write_latency = 0;
    Cycles read_stage = 0;
    bool may_keep_tokens = false;  ///< unread at the end of a run
    bool flushes = false;
    std::uint64_t hands_over = 0;  ///< no FIFO: so many calls may have begun that are not over; see with_calls()
    WhenFull when_full = WhenFull::freeze;  ///< if it flushes
    unsigned bits = 0;                      ///< of a token; 0: not there

    /// Tokens that fit.
    std::uint64_t capacity() const {
        return hands_over > 0 ? hands_over : depth + tokens_beyond_depth(kind, generation);
    }
    /// Tokens that it is built for: behind a pipeline that squeezes, those of the pipeline as well.
    std::uint64_t tokens() const { return depth + tokens_of_pipeline(); }
    std::uint64_t tokens_of_pipeline() const { return flushes && when_full == WhenFull::squeeze ? write_latency : 0; }
    /// As the timing sees it (docs/timing-model.md#fifos).
    timing::FifoShape shape() const;
};

struct MachineLoop {
    std::string name;
    bool is_present = true;
    std::string decided_by;
    std::size_t process = 0;
    std::string timed_by;  ///< "MODULE.LOOP" whose keys time it
    timing::InitiationInterval interval;
    Cycles depth = 1;
    bool is_pipelined = true, rewinds = false;
    Cycles entry_states = 0, exit_states = 0;
    std::vector<std::size_t> writes;  ///< numbers of FIFOs
    std::vector<MachineDependence> dependences;
    std::vector<std::size_t> reads;  ///< those it was told of: all if it writes, or reads in a later stage
    bool makes_attempts = false;     ///< at any of its FIFOs

    /// The number of its dependence on a memory, if it has one.
    std::optional<std::size_t> dependence_on(std::size_t memory) const;
    /// Whether its iterations wait for each other's writes.
    bool has_interlocks() const;
    /// Without its FIFOs.
    timing::LoopShape shape() const;
};

struct MachineMemory {
    std::string name;
    bool is_present = true;
    std::string decided_by;
    std::size_t owner = 0;   ///< number of the process that has it
    std::size_t reader = 0;  ///< and of the one that reads it out; mostly the same
    std::uint64_t words = 0;
    std::uint64_t cols = 1;     ///< of its rows of words
    std::uint64_t ports = 2;    ///< of a bank
    std::uint64_t sharers = 1;  ///< cores that access one copy
    MemoryShape shape;
    BankPartition partition;
};

/// A process's end of the external memory.
struct MachineStream {
    std::string name;  ///< of the master
    bool is_present = true;
    std::string decided_by;
    std::size_t process = 0;
    std::string loop;  ///< of the process, which takes tokens; empty: steps do
    bool writes = false;
    timing::Prefetch prefetch = timing::Prefetch::none;
    bool is_header = false;

    timing::MemoryStream::EntersBy enters_by() const;
};

/// One configuration of a design with everything resolved: what its cores consist of, and how long what takes. All
/// tables, reports, waveforms and retimings ask it.
struct Machine {
    std::uint64_t cores = 1;
    double clock_mhz = 200.0;
    std::string cores_are;  ///< what reports call cores, and say of the machine besides
    std::string remark;
    std::vector<MachineProcess> processes;
    std::vector<MachineFifo> fifos;
    std::vector<MachineLoop> loops;
    std::vector<MachineMemory> memories;
    std::vector<MachineStream> streams;                     ///< masters, in the order that settles ties
    std::optional<timing::ExternalMemory> external_memory;  ///< none: ideal
    std::vector<LineBuffer> line_buffers;
    timing::Lead lead;
    std::size_t begins = 0;                          ///< process whose stamps begin samples
    std::size_t ends = 0;                            ///< process whose stamps end them
    bool is_over_with_last_sample = false;           ///< what processes do after that is not part of the run
    bool has_calls = false;                          ///< its processes tell when a call begins
    std::shared_ptr<TellResources const> resources;  ///< asked by resources_of(); or none

    double milliseconds(Cycles cycles) const { return static_cast<double>(cycles) / (clock_mhz * 1e3); }
    /// Of the table of processes of a core: it ends with the last that is there.
    std::size_t process_places() const;
    /// "MODULE.LOOP".
    std::string loop_name(std::size_t loop) const {
        return processes[loops[loop].process].name + '.' + loops[loop].name;
    }
    /// Of a part by its name. Errors: InputError if there is none.
    std::size_t process(std::string_view name) const;
    std::size_t fifo(std::string_view name) const;
    std::size_t memory(std::string_view name) const;
    std::size_t stream(std::string_view name) const;
    std::size_t loop(std::size_t process, std::string_view name) const;
};

/// Resolves what a configuration asks of a design.
Machine make_machine(CoreDescription const& core, MachineSettings const& settings);

/// "MODULE.LOOP" whose keys time a loop of a module.
std::string keyed_loop(ModuleDescription const& module, LoopDescription const& loop);
/// "MODULE.LOOP" whose keys time the loop with a name within a module. Errors: InputError if it has no such loop.
std::string keyed_loop(ModuleDescription const& module, std::string const& loop);

/// What keeps a loop from rewinding, as its module has nothing more to do for a call that is over; null: nothing.
char const* against_rewinding(Machine const& machine, MachineLoop const& loop);

/// Numbers of the parts that are there, in order.
std::vector<std::size_t> modules_of(Machine const& machine);
std::vector<std::size_t> fifos_of(Machine const& machine);
std::vector<std::size_t> loops_of(Machine const& machine);
std::vector<std::size_t> brams_of(Machine const& machine);
std::vector<std::size_t> streams_of(Machine const& machine);
/// The masters of an external memory: the streams of every core that are there.
std::vector<timing::MemorySystem::MasterShape> masters_of(Machine const& machine);

/// Whether iterations of any loop wait for others to write.
bool has_interlocks(Machine const& machine);

/// Whether any process accesses a FIFO without waiting: what such a design does depends on when.
bool makes_attempts(Machine const& machine);

/// Block RAMs of 36 Kbit of one core, line buffers included; without FIFOs.
double ramb36_of_core(Machine const& machine);

}  // namespace dataflow
