#include <algorithm>
#include <fmt/format.h>

#include "dataflow/core/time/operation.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/design_check.hpp"
#include "dataflow/run/config/machine_keys.hpp"

namespace dataflow {
namespace {

constexpr Cycles longest_interlock = timing::Operation::longest_count;  ///< of the distances that are recorded
constexpr std::uint64_t most_banks = 1024;                              ///< more than any device has block RAMs

std::int64_t integer_of(LoadedConfig const& loaded, std::string const& key) {
    return std::get<std::int64_t>(find_key(key)->read(loaded.config));
}

std::int64_t default_of(std::string const& key) { return std::get<std::int64_t>(find_key(key)->read(RunConfig())); }

/// An access happens before the pipeline ends. If only the loop's depth was set, that is what the message blames.
/// `depth_key`: of the loop that accesses.
void check_stage(LoadedConfig const& loaded, std::string const& stage_key, std::string const& depth_key,
                 std::vector<std::string>& complaints) {
    std::int64_t const stage = integer_of(loaded, stage_key);
    std::int64_t const depth = integer_of(loaded, depth_key);
    if (stage < depth)
        return;
    if (loaded.origins.is_explicit(stage_key)) {
        complaints.push_back(complaint(
            loaded, stage_key, fmt::format("at most {}, one less than {}", depth - 1, with_value(loaded, depth_key))));
    } else {
        complaints.push_back(complaint(loaded, depth_key,
                                       fmt::format("at least {} because of {}: set that too, to at most {}", stage + 1,
                                                   with_value(loaded, stage_key), depth - 1)));
    }
}

/// By a loop's iterations: of an end that says so, or that the loop names.
bool is_accessed_by(LoopDescription const& loop, FifoEnd const& end) {
    std::vector<std::string> const& named = end.writes ? loop.writes : loop.reads;
    return loop.name == end.loop || std::find(named.begin(), named.end(), end.fifo) != named.end();
}

/// Of a FIFO that several modules may write, or read, what the ones say that do. Only loops that are there count.
void check_stages(LoadedConfig const& loaded, CoreDescription const& core, MachineFifo const& fifo,
                  std::vector<std::string>& complaints) {
    if (!fifo.is_present)
        return;
    for (bool const writes : {true, false}) {
        ModuleDescription const& module = core.modules[writes ? fifo.writer : fifo.reader];
        std::string const stage_key = fifo_key_name(fifo.name, writes ? "write_latency" : "read_stage");
        for (FifoEnd const& end : module.ends)
            for (LoopDescription const& loop : module.loops)
                if (end.writes == writes && end.fifo == fifo.name && !end.loop.empty() && hold(end.conditions) &&
                    hold(loop.conditions) && is_accessed_by(loop, end))
                    check_stage(loaded, stage_key, stages_key_name(module, loop.name), complaints);
    }
}

/// Of stages that somebody has asked for.
void check_dependence(LoadedConfig const& loaded, std::string const& loop, std::string const& memory,
                      std::vector<std::string>& complaints) {
    std::string const depth_key = loop_key_name(loop, "depth");
    std::string const read_key = dependence_key_name(loop, memory, "read_stage");
    std::string const write_key = dependence_key_name(loop, memory, "write_stage");
    auto const is_asked_for = [&](std::string const& key) {
        return loaded.origins.is_explicit(key) && integer_of(loaded, key) != default_of(key);
    };
    for (std::string const& key : {read_key, write_key})
        if (is_asked_for(key) && integer_of(loaded, key) >= integer_of(loaded, depth_key))
            complaints.push_back(
                complaint(loaded, key,
                          fmt::format("at most {}, one less than {}", integer_of(loaded, depth_key) - 1,
                                      with_value(loaded, depth_key))));
    if ((is_asked_for(read_key) || is_asked_for(write_key)) &&
        integer_of(loaded, read_key) > integer_of(loaded, write_key))
        complaints.push_back(complaint(loaded, is_asked_for(read_key) ? read_key : write_key,
                                       fmt::format("no read behind the write, with {}",
                                                   with_value(loaded, is_asked_for(read_key) ? write_key : read_key))));
}

/// In its last stage.
bool gives_to_memory(Machine const& machine, MachineLoop const& loop) {
    return std::any_of(machine.streams.begin(), machine.streams.end(), [&loop](MachineStream const& stream) {
        return stream.is_present && stream.writes && stream.process == loop.process && stream.loop == loop.name;
    });
}

/// Iterations that wait let those before them go on, whose later accesses would no longer be II apart. How long one
/// waits that makes an attempt may depend on what that finds, and so on the cycle of it.
void check_interlocks(LoadedConfig const& loaded, Machine const& machine, MachineLoop const& loop,
                      std::vector<std::string>& complaints) {
    auto const is_there = [&machine](std::size_t fifo) { return machine.fifos[fifo].is_present; };
    auto const reads_late = [&](std::size_t fifo) { return is_there(fifo) && machine.fifos[fifo].read_stage > 0; };
    bool const gives_late =
        gives_to_memory(machine, loop) && loop.depth > 1 && std::any_of(loop.reads.begin(), loop.reads.end(), is_there);
    bool const can_wait = !loop.makes_attempts && !gives_late &&
                          std::none_of(loop.writes.begin(), loop.writes.end(), is_there) &&
                          std::none_of(loop.reads.begin(), loop.reads.end(), reads_late);
    for (MachineDependence const& dependence : loop.dependences) {
        if (!dependence.interlocks())
            continue;
        auto const key = [&](char const* field) {
            return dependence_key_name(loop.timed_by, machine.memories[dependence.memory].name, field);
        };
        if (!can_wait)
            complaints.push_back(
                complaint(loaded, key("hazards"),
                          "report or forward: the loop writes FIFOs, reads one in a later stage than "
                          "its first, or without waiting, or gives to the memory behind what it reads"));
        else if (dependence.longest_span > longest_interlock)
            complaints.push_back(complaint(loaded, key("write_stage"),
                                           fmt::format("at most {} behind {}, with hazards interlock",
                                                       longest_interlock - 1, with_value(loaded, key("read_stage")))));
    }
}

void check_rewind(LoadedConfig const& loaded, Machine const& machine, MachineLoop const& loop,
                  std::vector<std::string>& complaints) {
    if (char const* const obstacle = against_rewinding(machine, loop); loop.rewinds && obstacle != nullptr)
        complaints.push_back(
            complaint(loaded, loop_key_name(loop.timed_by, "rewind"), fmt::format("false, as the loop {}", obstacle)));
}

std::string type_needed(LoadedConfig const& loaded, std::string const& memory, char const* without) {
    return fmt::format("{}, or {} to be cyclic or block", without,
                       with_value(loaded, bram_key_name(memory, "partition.type")));
}

/// Words along the shortest dimension that is split.
std::uint64_t most_parts(MemoryDescription const& memory, PartitionConfig const& partition) {
    return partition.dimension == 1   ? memory.rows
           : partition.dimension == 2 ? memory.cols
                                      : std::min(memory.rows, memory.cols);
}

/// As a message names most_parts().
std::string most_parts_text(LoadedConfig const& loaded, MemoryDescription const& memory,
                            PartitionConfig const& partition) {
    if (!memory.size_key.empty())
        return with_value(loaded, memory.size_key);
    std::uint64_t const most = most_parts(memory, partition);
    return fmt::format("{}, the {} of {}, with {}", most,
                       most == memory.cols && partition.dimension != 1 ? "columns" : "rows", memory.name,
                       with_value(loaded, bram_key_name(memory.name, "partition.dimension")));
}

/// Banks need words, and a factor a type.
void check_partition(LoadedConfig const& loaded, MemoryDescription const& memory,
                     std::vector<std::string>& complaints) {
    PartitionConfig const partition = loaded.config.machine().memory(memory.name).partition;
    std::string const factor_key = bram_key_name(memory.name, "partition.factor");
    std::string const dimension_key = bram_key_name(memory.name, "partition.dimension");
    bool const is_split = partition.type != PartitionType::none;
    if (!is_split && partition.factor != 1) {
        complaints.push_back(complaint(loaded, factor_key, type_needed(loaded, memory.name, "1")));
    } else if (!is_split && partition.dimension != 0) {
        complaints.push_back(complaint(loaded, dimension_key, type_needed(loaded, memory.name, "0")));
    } else if (!is_split) {
        return;
    } else if (partition.factor > most_parts(memory, partition)) {
        complaints.push_back(complaint(loaded, factor_key, "at most " + most_parts_text(loaded, memory, partition)));
    } else if (BankPartition(partition, static_cast<std::int64_t>(memory.rows), static_cast<std::int64_t>(memory.cols))
                   .banks() > most_banks) {
        complaints.push_back(
            complaint(loaded, factor_key,
                      fmt::format("at most {} banks in all, with {}", most_banks, with_value(loaded, dimension_key))));
    }
}

}  // namespace

std::vector<std::string> machine_complaints(LoadedConfig const& loaded) {
    CoreDescription const core = design().core(loaded.config);
    check_design(core);
    std::vector<std::string> complaints;
    Machine const machine = make_machine(core, loaded.config.machine());
    for (MachineFifo const& fifo : machine.fifos)
        check_stages(loaded, core, fifo, complaints);
    for (std::size_t const loop : loops_of(machine)) {
        check_interlocks(loaded, machine, machine.loops[loop], complaints);
        check_rewind(loaded, machine, machine.loops[loop], complaints);
    }
    for (ModuleDescription const& module : core.modules) {
        for (MemoryDescription const& memory : module.memories)
            check_partition(loaded, memory, complaints);
        for (LoopDescription const& loop : module.loops)
            for (MemoryStages const& stages : loop.memory_stages)
                check_dependence(loaded, keyed_loop(module, loop), stages.memory, complaints);
    }
    return complaints;
}

}  // namespace dataflow
