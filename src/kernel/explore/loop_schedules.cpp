#include "kernel/explore/loop_schedules.hpp"

#include <fmt/format.h>

#include "kernel/config/design.hpp"

namespace faster::explore {

namespace {

/// "read (-1, 0)": rows down, columns to the right of the pixel that the iteration works on.
std::string text_of(BankPartition::Access const& access) {
    return fmt::format("{} ({}, {})", access.writes ? "write" : "read", access.at.row, access.at.col);
}

/// Of all cores that share the memory: one port after the other, then the next cycle.
Json slots(MachineMemory const& memory, std::vector<BankPartition::Access> const& accesses) {
    Json cycles = Json::array();
    std::size_t dealt = 0;
    for (std::uint64_t sharer = 0; sharer < memory.sharers; ++sharer)
        for (BankPartition::Access const& access : accesses) {
            if (dealt++ % memory.ports == 0)
                cycles.push_back(Json::array());
            cycles.back().push_back(text_of(access));
        }
    return cycles;
}

Json memory_schedule(MachineMemory const& memory, AccessPattern const& pattern) {
    return {{"bram", memory.name},
            {"banks", memory.partition.banks()},
            {"ports", memory.ports},
            {"sharers", memory.sharers},
            {"accesses", pattern.accesses()},
            {"cycles", slots(memory, memory.partition.fullest_bank(pattern))}};
}

Json loop_schedule(Machine const& machine, std::size_t loop, LoopDescription const& description) {
    timing::InitiationInterval const& interval = machine.loops[loop].interval;
    Json memories = Json::array();
    for (MemoryAccess const& access : description.accesses)
        if (MachineMemory const& memory = machine.memories[machine.memory(access.memory)];
            memory.is_present && access.pattern.accesses() > 0)
            memories.push_back(memory_schedule(memory, access.pattern));
    return {{"loop", machine.loop_name(loop)},   {"does", description.task},
            {"ii", interval.achieved},           {"target", interval.target},
            {"recurrence", interval.recurrence}, {"ports", interval.ports},
            {"limited_by", interval.limited_by}, {"memories", memories}};
}

}  // namespace

Json loop_schedules(RunConfig const& config) {
    CoreDescription const core = design().core(config);
    Machine const machine = machine_of(config);
    Json rows = Json::array();
    std::size_t number = 0;
    for (ModuleDescription const& module : core.modules)
        for (LoopDescription const& loop : module.loops) {
            if (machine.loops[number].is_present)
                rows.push_back(loop_schedule(machine, number, loop));
            ++number;
        }
    return rows;
}

}  // namespace faster::explore
