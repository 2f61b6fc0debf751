#include "kernel/report/csv.hpp"

#include <fmt/format.h>
#include <iterator>

#include "faster/machine.hpp"
#include "faster/parts.hpp"

namespace faster::report {

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

std::string samples_csv(RunStatistics const& run) {
    std::string text =
        "sample,core,start_cycle,end_cycle,latency_cycles,valid_raster,valid_depth,inlier,valid_edge,edge_inlier\n";
    for (SampleStatistics const& s : run.samples)
        fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{}\n", s.sample, s.core, s.start_cycle,
                       s.end_cycle, s.latency_cycles(), s.counters.valid_raster, s.counters.valid_depth,
                       s.counters.inlier, s.counters.valid_edge, s.counters.edge_inlier);
    return text;
}

std::string fifos_csv(RunStatistics const& run) {
    std::string text =
        "core,fifo,kind,depth,write_latency,writes,reads,full_stall_cycles,empty_stall_cycles,max_occupancy\n";
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : fifos_of(run.parts)) {
            FifoStatistics const& f = run.cores[core].fifos[i];
            fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{}\n", core, fifo_names[i],
                           kind_name(f.kind), f.depth, f.write_latency, f.writes, f.reads, f.full_stall_cycles,
                           f.empty_stall_cycles, f.max_occupancy);
        }
    return text;
}

/// SPEC section 4 lists the loops that touch block RAM, and the scan; the vertex and observation loops are left out.
static bool is_listed(LoopId id) { return id != LoopId::vertex && id != LoopId::read; }

std::string loops_csv(RunStatistics const& run) {
    std::string text =
        "core,module,loop,ii_target,ii_recurrence,ii,depth,entries,iterations,port_conflict_cycles,recurrence_cycles,"
        "limited_by\n";
    for (std::size_t core = 0; core < run.cores.size(); ++core)
        for (std::size_t const i : loops_of(run.parts)) {
            if (!is_listed(static_cast<LoopId>(i)))
                continue;
            LoopStatistics const& l = run.cores[core].loops[i];
            fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{}\n", core,
                           name_of(loop_names[i].module), loop_names[i].name, l.ii_target, l.ii_recurrence, l.ii,
                           l.depth, l.entries, l.iterations, l.port_conflict_cycles, l.recurrence_cycles, l.limited_by);
        }
    return text;
}

}  // namespace faster::report
