#include "dataflow/run/figures/diagnosis.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "dataflow/tools/report/diagnosis_text.hpp"
#include "faster/dataflow_names.hpp"
#include "support/idle_run.hpp"
#include "support/parts.hpp"
#include "support/raster_machine.hpp"

namespace faster::diagnosis_test {

using testing::FifoId;
using testing::LoopId;
using testing::ModuleId;

/// The default design, with this many cores that have done nothing.
RunStatistics idle_run(std::size_t cores) { return testing::idle_run(testing::raster_machine({}), cores); }

/// Two cores; the second ends last, and its inlier unit waits least. 1000 cycles.
RunStatistics example() {
    RunStatistics run = idle_run(2);
    run.total_cycles = 1000;
    run.cores[0].end_cycle = 900;
    run.cores[1].end_cycle = 1000;
    for (ProcessStatistics& process : run.cores[1].processes)
        process[CycleClass::empty_stall] = 900;
    ProcessStatistics& inlier = run.cores[1].processes[index_of(ModuleId::inlier_unit)];
    inlier[CycleClass::busy] = 250;
    inlier[CycleClass::port_conflict] = 400;
    inlier[CycleClass::empty_stall] = 300;
    inlier[CycleClass::fill_drain] = 45;
    inlier[CycleClass::idle_after] = 5;
    inlier.stalls[index_of(FifoId::command)] = 100;
    inlier.stalls[index_of(FifoId::edge_map)] = 200;
    LoopStatistics& sweep = run.cores[1].loops[index_of(LoopId::sweep)];
    sweep.ii = 3;
    sweep.iterations = 200;
    sweep.port_conflict_cycles = 400;
    run.cores[0].loops[index_of(LoopId::sweep)].limited_by = "depth_buffer";
    run.cores[0].loops[index_of(LoopId::sweep)].bram = "depth_buffer";
    run.cores[0].loops[index_of(LoopId::sweep)].bram_accesses = 5;
    run.cores[0].loops[index_of(LoopId::sweep)].ii = 3;
    return run;
}

TEST_CASE("A run is bound by the module that waits least in the core that ends last", "[diagnosis]") {
    Diagnosis const diagnosis = diagnose(example());
    CHECK(diagnosis.core == 1);
    CHECK(diagnosis.module == index_of(ModuleId::inlier_unit));
    CHECK(diagnosis.waits == 305);
    std::vector<Cycles> cycles;
    Cycles sum = 0;
    for (Cause const& cause : diagnosis.causes) {
        cycles.push_back(cause.cycles);
        sum += cause.cycles;
    }
    CHECK(cycles == std::vector<Cycles>{600, 200, 100, 50, 45, 5});  // sweep, edge_map, command, the rest, drain, idle
    CHECK(sum == 1000);
    CHECK(diagnosis.causes[0].port_conflict == 400);
}

TEST_CASE("The diagnosis says why in sentences, the largest cause first, none below one percent", "[diagnosis]") {
    std::vector<std::string> const sentences = report::diagnosis_sentences(example());
    REQUIRE(sentences.size() == 6);
    CHECK(sentences[0] == "Bound by inlier_unit, which waits least: 30.5 % of the time of core 1, the last to end.");
    CHECK_THAT(sentences[1],
               Catch::Contains("60.0 % is inlier_unit.sweep at II 3, because depth_buffer has 5 accesses"));
    CHECK_THAT(sentences[1], Catch::EndsWith("per iteration on 2 ports: 40.0 % are port conflicts."));
    CHECK(sentences[2] == "20.0 % inlier_unit waits for edge_map_builder: edge_map is empty.");
    CHECK(sentences[3] == "10.0 % inlier_unit waits for rasterizer: command is empty.");
    CHECK(sentences[4] == "5.0 % is inlier_unit between its loops.");
    CHECK(sentences[5] == "4.5 % is inlier_unit filling and draining pipelines.");
}

TEST_CASE("The diagnosis tells what iterations waited for writes", "[diagnosis]") {
    RunStatistics run = example();
    LoopStatistics& fragment = run.cores[1].loops[index_of(LoopId::fragment)];
    fragment.iterations = 20;
    fragment.interlock_cycles = fragment.recurrence_cycles = 15;
    ProcessStatistics& inlier = run.cores[1].processes[index_of(ModuleId::inlier_unit)];
    inlier[CycleClass::busy] -= 15;
    inlier[CycleClass::recurrence] = 15;
    Diagnosis const diagnosis = diagnose(run);
    Cycles sum = 0;
    for (Cause const& cause : diagnosis.causes)
        sum += cause.cycles;
    CHECK(sum == 1000);
    std::vector<std::string> const sentences = report::diagnosis_sentences(run);
    std::string const expected = "3.5 % is inlier_unit.fragment at II 1: 1.5 % of iterations that wait for writes.";
    CHECK(std::count(sentences.begin(), sentences.end(), expected) == 1);
}

TEST_CASE("A run without samples is bound by nothing", "[diagnosis]") {
    CHECK(report::diagnosis_sentences(idle_run(0)).empty());
}

TEST_CASE("Tokens that are left in a FIFO are named", "[diagnosis]") {
    RunStatistics run = idle_run(2);
    CHECK(leftover_tokens(run).empty());
    run.cores[1].fifos[index_of(FifoId::area)].writes = 3;
    run.cores[1].fifos[index_of(FifoId::area)].reads = 1;
    CHECK(leftover_tokens(run) == "area of core 1 (2)");
}

}  // namespace faster::diagnosis_test
