#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/machine/dependence.hpp"
#include "dataflow/core/machine/fifo_kind.hpp"
#include "dataflow/core/machine/partition_config.hpp"

namespace dataflow {

/// Whether data from outside the cores cost time: `ideal`, they are there when they are asked for; `axi`, they come in
/// bursts through ports and one controller, which all cores share.
enum class MemoryModel { ideal, axi };

/// What a configuration asks of the external memory; keys `accelerator.memory.*`.
struct ExternalMemorySettings {
    MemoryModel model = MemoryModel::ideal;
    std::uint64_t burst_bytes = 256;  ///< a power of two, at least port_bytes; ranges are cut at its multiples
    std::uint64_t port_bytes = 16;    ///< bytes of a beat, a power of two
    std::uint64_t outstanding = 16;   ///< bursts of a master that are asked for and not done, >= 1
    bool prefetch = false;            ///< masters work ahead of their processes
    std::uint64_t ports = 3;          ///< core c uses port c mod ports, >= 1
    Cycles request_cycles = 24;       ///< from asking to the controller
    double dram_gb_per_s = 19.2;      ///< peak of the controller, 1e9 bytes per second
    double dram_efficiency = 0.75;    ///< part of it that can be had, above 0, at most 1
    double read_latency_ns = 120.0;   ///< from a burst's begin to its first beat at the port
};

/// What a configuration asks of one FIFO; keys `accelerator.fifos.NAME.*`. What is not set has the default of the
/// design's description.
struct FifoSettings {
    std::optional<std::uint64_t> depth;  ///< tokens, >= 1
    std::optional<FifoKind> kind;
    std::optional<Cycles> write_latency;  ///< stage of the writing loop in which a token leaves
    std::optional<Cycles> read_stage;     ///< stage of the reading loop in which a token is taken
    std::optional<WhenFull> when_full;    ///< of a flushing pipeline in front of it; key `accelerator.MODULE.when_full`
};

/// One pipelined loop; keys `accelerator.loops.MODULE.LOOP.*`.
struct LoopSettings {
    std::optional<Cycles> ii;             ///< initiation interval asked for by the pragma, >= 1
    std::optional<Cycles> recurrence_ii;  ///< initiation interval that a loop-carried dependence demands, >= 1
    std::optional<Cycles> depth;          ///< pipeline stages, >= 1; states of a loop that is not pipelined
    std::optional<Cycles> entry_states, exit_states;  ///< of such a loop
    std::optional<bool> rewind;                       ///< of one that can
};

/// How calls of a core's modules follow each other; key `accelerator.calls` (docs/timing-model.md#calls).
enum class CallOrder {
    overlapped,  ///< each module begins its next one as soon as it can
    in_turn,     ///< none begins before all modules are done with the one before
};

/// One block RAM; keys `accelerator.brams.NAME.*`.
struct MemorySettings {
    std::uint64_t ports = 2;  ///< accesses per cycle and bank, >= 1
    PartitionConfig partition;
};

/// What a loop does to one block RAM, and when; keys `accelerator.loops.MODULE.LOOP.NAME.*`. Stages that are not set
/// are those of the description, or in a shorter pipeline its last.
struct DependenceSettings {
    std::optional<Cycles> read_stage;
    std::optional<Cycles> write_stage;
    HazardHandling hazards = HazardHandling::report;
};

/// What a configuration asks of the parts of a machine, by their names. A loop's name is MODULE.LOOP.
struct MachineSettings {
    std::uint64_t cores = 1;
    double clock_mhz = 200.0;
    FifoGeneration fifo_rules = FifoGeneration::vitis_hls;
    CallOrder calls = CallOrder::overlapped;
    ExternalMemorySettings external_memory;
    std::map<std::string, FifoSettings> fifos;
    std::map<std::string, LoopSettings> loops;
    std::map<std::string, DependenceSettings> dependences;  ///< by MODULE.LOOP.MEMORY
    std::map<std::string, MemorySettings> memories;
    std::map<std::string, std::optional<Cycles>> setups;          ///< cycles of a module's setup; by module
    std::map<std::string, Cycles> starts;                         ///< cycles after the region's begin; by module
    std::map<std::string, std::optional<std::uint64_t>> numbers;  ///< keys `accelerator.modules.MODULE.NAME`

    FifoSettings& fifo(std::string const& name) { return fifos[name]; }
    LoopSettings& loop(std::string const& name) { return loops[name]; }
    DependenceSettings& dependence(std::string const& name) { return dependences[name]; }
    MemorySettings& memory(std::string const& name) { return memories[name]; }
    std::optional<Cycles>& setup(std::string const& module) { return setups[module]; }
    Cycles& start(std::string const& module) { return starts[module]; }
    std::optional<std::uint64_t>& number(std::string const& name) { return numbers[name]; }

    FifoSettings fifo(std::string const& name) const { return found(fifos, name); }
    LoopSettings loop(std::string const& name) const { return found(loops, name); }
    DependenceSettings dependence(std::string const& name) const { return found(dependences, name); }
    MemorySettings memory(std::string const& name) const { return found(memories, name); }
    std::optional<Cycles> setup(std::string const& module) const { return found(setups, module); }
    Cycles start(std::string const& module) const { return found(starts, module); }
    std::optional<std::uint64_t> number(std::string const& name) const { return found(numbers, name); }

  private:
    template <class Settings>
    static Settings found(std::map<std::string, Settings> const& all, std::string const& name) {
        auto const at = all.find(name);
        return at == all.end() ? Settings{} : at->second;
    }
};

}  // namespace dataflow
