#include "kernel/report/json_rows.hpp"

#include "kernel/report/csv.hpp"

namespace faster::report {

namespace {

/// What is not zero, by name.
template <std::size_t N> Json by_name(std::array<Cycles, N> const& cycles, std::array<char const*, N> const& names) {
    Json object = Json::object();
    for (std::size_t i = 0; i < N; ++i)
        if (cycles[i] > 0)
            object[names[i]] = cycles[i];
    return object;
}

}  // namespace

Json module_row(std::size_t core, std::size_t i, ProcessStatistics const& p) {
    Json row{{"core", core}, {"module", module_names[i]}};
    for (std::size_t c = 0; c < cycle_class_count; ++c)
        row[std::string(cycle_class_names[c]) + "_cycles"] = p.cycles[c];
    row["stalls"] = by_name(p.stalls, fifo_names);
    row["port_conflicts"] = by_name(p.port_conflicts, bram_names);
    return row;
}

Json fifo_row(std::size_t core, std::size_t i, FifoStatistics const& f) {
    return {{"core", core},
            {"fifo", fifo_names[i]},
            {"kind", kind_name(f.kind)},
            {"depth", f.depth},
            {"capacity", f.capacity},
            {"write_latency", f.write_latency},
            {"writes", f.writes},
            {"reads", f.reads},
            {"full_stall_cycles", f.full_stall_cycles},
            {"empty_stall_cycles", f.empty_stall_cycles},
            {"max_occupancy", f.max_occupancy}};
}

Json loop_row(std::size_t core, std::size_t i, LoopStatistics const& l) {
    return {{"core", core},
            {"module", name_of(loop_names[i].module)},
            {"loop", loop_names[i].name},
            {"ii_target", l.ii_target},
            {"ii_recurrence", l.ii_recurrence},
            {"ii", l.ii},
            {"depth", l.depth},
            {"entries", l.entries},
            {"iterations", l.iterations},
            {"port_conflict_cycles", l.port_conflict_cycles},
            {"recurrence_cycles", l.recurrence_cycles},
            {"limited_by", l.limited_by}};
}

}  // namespace faster::report
