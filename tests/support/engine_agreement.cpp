#include "support/engine_agreement.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "dataflow/run/replay/retime.hpp"
#include "faster/dataflow_names.hpp"
#include "support/cycle_twin.hpp"
#include "support/raster_machine.hpp"
#include "support/run_cells.hpp"
#include "support/test_run.hpp"

namespace faster::testing {
namespace {

/// One workload on one machine, run by both engines and the twin.
struct Trial {
    TwinResult twin;
    RunStatistics lockstep;
    RunStatistics decoupled;
};

void check_figures(Trial const& trial) {
    for (Part const part : {Part::Samples, Part::Fifos, Part::Loops, Part::Stalls, Part::Memory}) {
        CHECK(first_difference(cells_of(trial.decoupled, part), cells_of(trial.twin, part)) == "");
        CHECK(first_difference(cells_of(trial.lockstep, part), cells_of(trial.twin, part)) == "");
    }
}

/// Every cycle of the run, from cycle 0 on, is in exactly one class of every process.
void check_buckets(RunStatistics const& run) {
    for (std::size_t core = 0; core < run.cores.size(); ++core) {
        for (std::size_t const i : modules_of(run.machine)) {
            CAPTURE(core, module_ids[i].name);
            ProcessStatistics const& process = run.cores[core].processes[i];
            CHECK(process.sum() + run.load_cycles == run.total_cycles);
            for (Cycles const cycles : process.cycles)
                CHECK(cycles <= run.total_cycles);  // unsigned: not below zero
            CHECK(std::accumulate(process.stalls.begin(), process.stalls.end(), Cycles{0}) ==
                  process[CycleClass::empty_stall] + process[CycleClass::full_stall]);
        }
    }
}

void check_deadlock(Trial const& trial) {
    REQUIRE(trial.decoupled.deadlocked() == trial.twin.deadlock);
    REQUIRE(trial.lockstep.deadlocked() == trial.twin.deadlock);
    if (!trial.twin.deadlock)
        return;
    CHECK(trial.decoupled.deadlock_cycle() == trial.twin.deadlock_cycle);
    CHECK(trial.lockstep.deadlock_cycle() == trial.twin.deadlock_cycle);
    CHECK(first_difference(stuck_cells(trial.decoupled), stuck_cells(trial.lockstep)) == "");
    CHECK(first_difference(position_cells(trial.decoupled), position_cells(trial.lockstep)) == "");
    CHECK_FALSE(trial.decoupled.wait_cycle().empty());
    CHECK(first_difference(cells_of(trial.decoupled, Part::Memory), cells_of(trial.twin, Part::Memory)) == "");
}

}  // namespace

bool check_agreement(AcceleratorConfig const& config, Stimulus const& stimulus) {
    Trial const trial{run_twin(config, stimulus), test_run(config, stimulus, Engine::lockstep).statistics,
                      test_run(config, stimulus, Engine::decoupled).statistics};
    check_deadlock(trial);
    CHECK(first_difference(all_cells(trial.decoupled), all_cells(trial.lockstep)) == "");
    if (trial.twin.deadlock)
        return false;
    check_figures(trial);
    check_buckets(trial.lockstep);
    check_buckets(trial.decoupled);
    return true;
}

RunStatistics check_retiming(replay::RecordedRun const& recorded, AcceleratorConfig const& config,
                             Stimulus const& stimulus) {
    Machine const machine = raster_machine(config);
    RunStatistics const retimed = replay::retime(replay::ScriptedRun(recorded), machine);
    RunStatistics run = test_run(config, stimulus, Engine::lockstep).statistics;
    CHECK(retimed.deadlocked() == run.deadlocked());
    if (!run.deadlocked())
        CHECK(first_difference(all_cells(retimed), all_cells(run)) == "");
    return run;
}

}  // namespace faster::testing
