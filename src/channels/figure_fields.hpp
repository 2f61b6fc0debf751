#pragma once

namespace dataflow {

// Visit the fields of figures, to send or to receive them: both sides share the list. Sizes of vectors of rows are
// theirs to tell.

template <class Visit, class Row> void visit_sample(Visit visit, Row& row) {
    visit(row.sample, row.core, row.start_cycle, row.end_cycle, row.counters);
}

template <class Visit, class Row> void visit_core(Visit visit, Row& core) {
    visit(core.samples, core.end_cycle);
    for (auto& row : core.fifos)
        visit(row.kind, row.depth, row.capacity, row.write_latency, row.writes, row.reads, row.full_stall_cycles,
              row.empty_stall_cycles, row.max_occupancy);
    for (auto& row : core.loops)
        visit(row.ii_target, row.ii_recurrence, row.ii, row.depth, row.entries, row.iterations,
              row.port_conflict_cycles, row.recurrence_cycles, row.interlock_cycles, row.limited_by, row.bram,
              row.bram_accesses);
    for (auto& row : core.processes) {
        for (auto& cycles : row.cycles)
            visit(cycles);
        visit(row.stalls, row.port_conflicts);
    }
    for (auto& row : core.dependences)
        visit(row.loop, row.number, row.smallest, row.counts);
}

}  // namespace dataflow
