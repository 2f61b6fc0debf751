#include "kernel/explore/figures_json.hpp"

#include "kernel/figures/table_rows.hpp"
#include "kernel/report/diagnosis_text.hpp"
#include "kernel/report/html/deadlock_html.hpp"
#include "kernel/report/html/graph_data.hpp"
#include "kernel/report/html/run_data.hpp"
#include "kernel/report/json_rows.hpp"
#include "kernel/report/summary.hpp"
#include "kernel/sizing/cheapest_choice.hpp"

namespace faster::explore {

namespace {

Json primitives_json(Primitives const& primitives) {
    return {{"luts", primitives.luts},
            {"ramb36", static_cast<double>(primitives.ramb18) / 2},
            {"cost_luts", cost_of(primitives, {})}};
}

Json fifos_json(RunStatistics const& run) {
    sizing::Choice const choice = sizing::choice_of(run.machine);
    Json rows = Json::array();
    for (FifoRow const& row : over_cores(fifo_columns, fifo_rows(run))) {
        std::size_t const i = run.machine.fifo(row.fifo);
        rows.push_back(report::json_row(fifo_columns, row));
        rows.back().update(
            primitives_json(sizing::primitives_of(choice[i], sizing::freedom_of(run.machine.fifos[i]), {})));
    }
    return rows;
}

/// What one core takes.
Json area_json(Machine const& machine) {
    Json area = primitives_json(sizing::sum_of(sizing::choice_of(machine), sizing::freedoms_of(machine), {}));
    area["memories_ramb36"] = ramb36_of_core(machine);
    area["cost_of_cores"] = cost_of_cores(machine, area["cost_luts"]);
    return area;
}

}  // namespace

double cost_of_cores(Machine const& machine, double cost_of_fifos) {
    double const of_memories = ramb36_of_core(machine) * CostWeights{}.luts_per_ramb36;
    return static_cast<double>(machine.cores) * (cost_of_fifos + of_memories);
}

Json figures_json(RunStatistics const& run) {
    Json figures;
    figures["outcome"] = run.deadlocked() ? "deadlock" : "finished";
    figures["cores"] = run.machine.cores;
    figures["clock_mhz"] = run.machine.clock_mhz;
    figures["area"] = area_json(run.machine);
    figures["fifos"] = fifos_json(run);
    figures["brams"] = report::memory_data(run.machine);
    figures["loops"] = report::json_table(loop_columns, over_cores(loop_columns, loop_rows(run)));
    if (run.deadlocked()) {
        figures["deadlock"] = report::deadlock_data(run);
        return figures;
    }
    figures["total_cycles"] = run.total_cycles;
    figures["milliseconds"] = run.machine.milliseconds(run.total_cycles);
    figures["modules"] = report::module_data(run);
    figures["stalls"] = report::stall_data(run);
    figures["bound_by"] = report::diagnosis_sentences(run);
    return figures;
}

}  // namespace faster::explore
