#include "stats/table_rows.hpp"

namespace faster {

namespace {

char const* kind_name(FifoKind kind) {
    switch (kind) {
        case FifoKind::automatic:
            return "auto";
        case FifoKind::shift_register:
            return "shift_register";
        case FifoKind::memory:
            return "memory";
    }
    return "";
}

/// SPEC section 4 lists the loops that touch block RAM, and the scan; the vertex and observation loops are left out.
bool is_listed(LoopId id) { return id != LoopId::vertex && id != LoopId::read; }

Cycles port_conflict_cycles(CoreStatistics const& core, std::string const& bram) {
    Cycles conflicts = 0;
    for (LoopStatistics const& loop : core.loops)
        conflicts += loop.limited_by == bram ? loop.port_conflict_cycles : 0;
    return conflicts;
}

ModuleRow module_row(Parts const& parts, std::size_t core, std::size_t i, ProcessStatistics const& process) {
    ModuleRow row{core, module_names[i], process.cycles, {}, {}};
    for (std::size_t const f : fifos_of(parts)) {
        FifoEnds const ends = ends_of(parts, FifoId{f});
        if (index_of(ends.writer) == i || index_of(ends.reader) == i)
            row.stalls.push_back({fifo_names[f], process.stalls[f]});
    }
    for (std::size_t const b : brams_of(parts))
        row.port_conflicts.push_back({bram_names[b], process.port_conflicts[b]});
    return row;
}

}  // namespace

std::vector<ModuleRow> module_rows(RunStatistics const& run) {
    std::vector<ModuleRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : modules_of(run.parts))
            rows.push_back(module_row(run.parts, core, i, run.cores[core].processes[i]));
    return rows;
}

std::vector<ModuleRow> module_sums(RunStatistics const& run) {
    std::vector<ModuleRow> rows;
    for (std::size_t const i : modules_of(run.parts))
        rows.push_back(module_row(run.parts, 0, i, process_sum(run, i)));
    return rows;
}

std::vector<FifoRow> fifo_rows(RunStatistics const& run) {
    std::vector<FifoRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : fifos_of(run.parts)) {
            FifoStatistics const& fifo = run.cores[core].fifos[i];
            rows.push_back({fifo, core, fifo_names[i], kind_name(fifo.kind)});
        }
    return rows;
}

std::vector<LoopRow> loop_rows(RunStatistics const& run) {
    std::vector<LoopRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : loops_of(run.parts))
            rows.push_back({run.cores[core].loops[i], core, name_of(loop_names[i].module), loop_names[i].name,
                            is_listed(static_cast<LoopId>(i))});
    return rows;
}

std::vector<MemoryRow> memory_rows(RunStatistics const& run, AcceleratorConfig const& config) {
    std::vector<MemoryRow> rows;
    for (std::size_t core = 0; core < run.cores.size(); ++core) {
        for (std::size_t const i : brams_of(run.parts)) {
            auto const id = static_cast<BramId>(i);
            rows.push_back(
                {memory_shape(id, config), core, name_of(id), port_conflict_cycles(run.cores[core], name_of(id))});
        }
        if (MemoryShape const shape = line_buffer_shape(config); shape.words > 0)
            rows.push_back({shape, core, "line_buffers", 0, false});
    }
    return rows;
}

}  // namespace faster
