#include "dataflow/base/write_distances.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <vector>

#include "dataflow/core/machine/dependence.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/run/replay/operation_check.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::write_distances_test {

using Counts = std::vector<std::uint64_t>;

TEST_CASE("Distances are counted from the last iteration that wrote the word", "[hazards]") {
    WriteDistances distances(8, 4);
    distances.enter();
    distances.next_iteration();
    distances.write(5);
    distances.next_iteration();
    distances.read(5);  // 1
    distances.next_iteration();
    distances.read(6);
    distances.write(5);  // 2
    distances.next_iteration();
    distances.next_iteration();
    distances.next_iteration();
    distances.read(5);  // 3, and no more than 4 of the first
    distances.next_iteration();
    distances.read(5);  // 4 is not below 4
    CHECK(distances.smallest() == 1);
    CHECK(distances.counts() == Counts{0, 1, 1, 1});
}

TEST_CASE("An iteration counts once for a word that it reads and writes, and never for what it wrote itself",
          "[hazards]") {
    WriteDistances distances(2, 3);
    distances.enter();
    for (int i = 0; i < 3; ++i) {
        distances.next_iteration();
        distances.read(1);
        distances.read(1);
        distances.write(1);
        distances.write(1);
        distances.read(1);
    }
    CHECK(distances.counts() == Counts{0, 2, 0});
}

TEST_CASE("What an earlier entry wrote is in the memory", "[hazards]") {
    WriteDistances distances(2, 3);
    for (int entry = 0; entry < 3; ++entry) {
        distances.enter();
        distances.next_iteration();
        distances.read(0);
        distances.write(0);
    }
    CHECK(distances.smallest() == 0);
    CHECK(distances.counts() == Counts{0, 0, 0});
}

TEST_CASE("A word is stale up to the cycle in which it is written, the cycle included", "[hazards]") {
    MachineDependence dependence;
    dependence.read_stage = 7;
    dependence.write_stage = 9;
    dependence.reads = 1;
    dependence.writes = 1;
    CHECK(dependence.span() == 3);
    CHECK(dependence.is_hazard(1, 1));
    CHECK(dependence.is_hazard(2, 1));
    CHECK_FALSE(dependence.is_hazard(3, 1));
    CHECK(dependence.is_hazard(1, 2));
    CHECK_FALSE(dependence.is_hazard(2, 2));
    CHECK_FALSE(dependence.is_hazard(1, 3));
    CHECK(dependence.reach(1) == 2);
    CHECK(dependence.reach(2) == 1);
    CHECK(dependence.reach(3) == 0);
    dependence.reads = 0;
    CHECK_FALSE(dependence.is_hazard(1, 1));
    CHECK(dependence.reach(1) == 0);
}

TEST_CASE("The nearest write is that of the iteration at hand, or of the one before it", "[hazards]") {
    WriteDistances distances(8, 4);
    distances.enter();
    distances.next_iteration();
    distances.write(5);
    distances.write(6);
    distances.next_iteration();
    distances.write(6);
    distances.next_iteration();
    CHECK(distances.nearest() == 0);
    CHECK(distances.nearest_before() == 1);
    distances.read(5);
    CHECK(distances.nearest() == 2);
    distances.read(6);
    CHECK(distances.nearest() == 1);
}

/// Cycles of a loop of five stages with interlocks on two memories. Before its i-th iteration it awaits a write so many
/// iterations ago, in each of the memories; 0: in none.
Cycles cycles_of_loop(Cycles ii, std::vector<std::array<unsigned, 2>> const& distances) {
    timing::CoreTiming core;
    timing::LoopShape shape;
    shape.interval.achieved = ii;
    shape.depth = 5;
    shape.interlock_spans = {4, 5};
    timing::ProcessTiming& process = core.add_process("process");
    timing::OperationLog& log = process.log();
    log.enter(process.add_loop(shape));
    for (std::array<unsigned, 2> const& of_memory : distances) {
        for (std::uint32_t i = 0; i < of_memory.size(); ++i)
            if (of_memory[i] > 0)
                log.await_write(i, of_memory[i]);
        log.iterate(timing::no_ports.number(), 0, 1);
    }
    log.leave();
    core.resolve();
    return process.local_time();
}

TEST_CASE("An iteration begins as many steps after a write that it awaits as the span says", "[hazards]") {
    CHECK(cycles_of_loop(1, {{0, 0}, {0, 0}, {0, 0}}) == 2 + 5);
    CHECK(cycles_of_loop(1, {{0, 0}, {1, 0}, {0, 0}}) == 2 + 5 + 3);
    CHECK(cycles_of_loop(1, {{0, 0}, {0, 1}, {0, 0}}) == 2 + 5 + 4);
    CHECK(cycles_of_loop(1, {{0, 0}, {1, 1}, {0, 0}}) == 2 + 5 + 4);  // the longer wait is enough for both
    CHECK(cycles_of_loop(1, {{0, 0}, {0, 0}, {2, 0}}) == 2 + 5 + 2);
    CHECK(cycles_of_loop(1, {{0, 0}, {1, 0}, {1, 0}}) == 2 + 5 + 3 + 3);
    CHECK(cycles_of_loop(1, {{0, 0}, {1, 0}, {2, 0}}) == 2 + 5 + 3);  // those 3 steps are between them
    CHECK(cycles_of_loop(1, {{0, 0}, {0, 0}, {1, 0}, {3, 0}}) == 3 + 5 + 3);
    // The last one is 3 iterations and both waits behind the write: enough.
    CHECK(cycles_of_loop(1, {{0, 0}, {0, 0}, {0, 0}, {3, 0}, {2, 0}, {0, 3}}) == 5 + 5 + 1 + 1);
    CHECK(cycles_of_loop(2, {{0, 0}, {1, 0}, {0, 0}}) == 2 * 2 + 5 + 2);
    CHECK(cycles_of_loop(4, {{0, 0}, {1, 0}, {0, 1}}) == 2 * 4 + 5 + 1);
}

TEST_CASE("What a file says is awaited is a write of a dependence of the loop", "[hazards]") {
    using timing::Operation;
    using Kind = Operation::Kind;
    timing::CoreTiming core;
    timing::ProcessTiming& process = core.add_process("process");
    timing::LoopShape with, without;
    with.interlock_spans = {4, 5};
    process.add_loop(with);
    process.add_loop(without);
    auto const await = [](std::uint32_t dependence, std::uint32_t distance) {
        return Operation(Kind::wait, 0, Operation::first_dependence + dependence, distance);
    };
    replay::OperationCheck check(process);
    CHECK_FALSE(check.accepts(await(0, 1)));  // outside loops
    REQUIRE(check.accepts(Operation(Kind::enter, 0, 0, 0)));
    CHECK(check.accepts(await(0, 1)));
    CHECK(check.accepts(await(1, Operation::longest_count)));
    CHECK_FALSE(check.accepts(await(1, 0)));
    CHECK_FALSE(check.accepts(await(2, 1)));
    CHECK_FALSE(check.accepts(Operation(Kind::wait, 0, Operation::longest_gap, 1)));
    REQUIRE(check.accepts(Operation(Kind::leave, 0, 0, 0)));
    REQUIRE(check.accepts(Operation(Kind::enter, 0, 0, 1)));
    CHECK_FALSE(check.accepts(await(0, 1)));  // nobody waits there
    check.set_state({true, false, 0});        // somewhere in a loop, as a phrase may begin
    CHECK(check.accepts(await(0, 1)));
    CHECK_FALSE(check.accepts(await(2, 1)));
}

}  // namespace faster::write_distances_test
