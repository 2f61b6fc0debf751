#include "dataflow/core/time/ports.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/replay/bytes.hpp"
#include "dataflow/run/replay/operation_check.hpp"
#include "dataflow/run/replay/operation_columns.hpp"
#include "faster/dataflow_names.hpp"

namespace dataflow::timing::ports_test {

std::vector<unsigned> list_of(Ports ports) {
    std::vector<unsigned> list;
    ports.each([&list](unsigned port) { list.push_back(port); });
    return list;
}

std::vector<unsigned> range(unsigned first, unsigned end) {
    std::vector<unsigned> ports;
    for (unsigned port = first; port < end; ++port)
        ports.push_back(port);
    return ports;
}

/// A hub that reads from many sources and writes to as many sinks, each a process of its own.
struct Star {
    static constexpr unsigned arms = 10;
    static constexpr unsigned reading = 0, writing = 1;  // loops of the hub

    Star() {
        for (unsigned i = 0; i < 2 * arms; ++i)
            core.add_fifo({"fifo " + std::to_string(i), 2 + i % 3, 1 + i % 2});
        hub = &core.add_process("hub");
        for (unsigned i = 0; i < 2 * arms; ++i) {
            ProcessTiming& arm = core.add_process("arm " + std::to_string(i));
            i < arms ? arm.add_writes(core.fifo(i)) : arm.add_reads(core.fifo(i));
        }
        for (unsigned i = 0; i < arms; ++i)
            hub->add_reads(core.fifo(i));
        for (unsigned i = 0; i < arms; ++i)
            hub->add_writes(core.fifo(arms + i));
        LoopShape loop;
        loop.name = "reading";
        loop.depth = 4;
        hub->add_loop(loop);
        loop.name = "writing";
        loop.depth = 9;
        for (unsigned i = 0; i < arms; ++i)
            loop.writes.push_back({arms + i, i % 7});
        hub->add_loop(loop);
    }

    OperationLog& arm(unsigned number) { return core.process(1 + number).log(); }
    /// `count` accesses of each arm, some cycles apart.
    void log_arms(unsigned count, unsigned seed) {
        std::mt19937 random(seed);
        for (unsigned i = 0; i < 2 * arms; ++i)
            for (unsigned n = 0; n < count; ++n)
                arm(i).step(1, 1 + random() % 4);
    }
    void log_hub() {
        Ports const all_in = Ports::of(range(0, arms)), all_out = Ports::of(range(arms, 2 * arms));
        OperationLog& log = hub->log();
        log.step((all_in | all_out).number(), 1);
        log.enter(reading);
        log.iterate(all_in.number(), 0, 20);
        log.iterate(Ports::of({1U, 9U}).number(), 1, 5);
        log.leave();
        log.enter(writing);
        log.iterate(all_out.number(), 0, 20);
        log.iterate(Ports::of({10U, 19U}).number(), 2, 5);
        log.leave();
    }

    std::vector<Cycles> figures() {
        std::vector<Cycles> figures;
        for (ProcessTiming const& process : core.processes())
            figures.insert(figures.end(), {process.local_time(), process.full_stall_cycles(),
                                           process.empty_stall_cycles(), process.finished() ? 1U : 0U});
        for (FifoTiming const& fifo : core.fifos())
            figures.insert(figures.end(), {fifo.writes(), fifo.reads(), fifo.full_stall_cycles(),
                                           fifo.empty_stall_cycles(), fifo.max_occupancy()});
        return figures;
    }

    std::unique_ptr<PhraseCore> const made = make_core();
    CoreTiming& core = *made;
    ProcessTiming* hub = nullptr;
};

void run_step_by_step(CoreTiming& core) {
    for (bool moved = true; moved;) {
        moved = false;
        for (std::size_t i = 0; i < core.processes().size(); ++i)
            for (; core.process(i).front() == ProcessTiming::Status::ready; moved = true)
                core.process(i).commit_front();
    }
}

TEST_CASE("A set of ports has a number, however many ports there are", "[ports]") {
    CHECK(Ports().is_empty());
    CHECK(Ports::of(3).number() == 8);
    CHECK((Ports::of(3) | Ports::of(0)).number() == 9);
    CHECK(list_of(Ports::of(3) | Ports::of(0)) == std::vector<unsigned>{0, 3});
    Ports const large = Ports::of(200) | Ports::of(3) | Ports::of(8);
    CHECK_FALSE(Ports::is_mask(large.number()));
    CHECK(list_of(large) == std::vector<unsigned>{3, 8, 200});
    CHECK(large == Ports::of({8U, 200U, 3U, 8U}));
    CHECK(large.first() == 3);
    CHECK(large.has(200));
    CHECK_FALSE(large.has(0));
    CHECK(Ports::is_known(large.number()));
    CHECK_FALSE(Ports::is_known(Ports::numbers));
    CHECK((large | Ports::of(3)) == large);
    CHECK((large | Ports()) == large);
}

TEST_CASE("A step at 20 ports waits for all of them, in program order", "[ports][timing]") {
    Star star;
    for (unsigned i = 0; i < Star::arms; ++i) {
        star.arm(i).wait(10 * i + 1);
        star.arm(i).step(1, 0);
    }
    star.hub->log().step(Ports::of(range(0, 2 * Star::arms)).number(), 5);
    star.core.resolve();
    // The last source writes in cycle 91; its token can be read Lf = 2 cycles later.
    CHECK(star.hub->local_time() == 91 + 2 + 5);
    for (unsigned i = 0; i < Star::arms; ++i) {
        CAPTURE(i);
        CHECK(star.core.fifo(i).empty_stall_cycles() == (i == 0 ? 2U : i % 2 == 0 ? 9U : 11U));
        CHECK(star.core.fifo(Star::arms + i).writes() == 1);
    }
}

TEST_CASE("Loops of many ports take the same cycles at once and step by step", "[ports][timing]") {
    for (unsigned seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        Star star, stepped;
        for (Star* const each : {&star, &stepped}) {
            each->log_arms(40, seed);
            each->log_hub();
        }
        auto const copy = star.core.blank_copy();
        for (std::size_t i = 0; i < copy->processes().size(); ++i)
            copy->process(i).log() = star.core.process(i).log();
        run_step_by_step(stepped.core);
        star.core.resolve();
        copy->resolve();
        CHECK(star.figures() == stepped.figures());
        CHECK(star.hub->finished());
        CHECK(copy->process(0).local_time() == star.hub->local_time());
        CHECK(star.core.fifo(1).reads() == 1 + 20 + 5);
        CHECK(star.core.fifo(19).writes() == 1 + 20 + 5);
        CHECK(star.core.fifo(12).writes() == 1 + 20);
    }
}

TEST_CASE("A loop without stalls takes (n - 1) II + L, however many ports it has", "[ports][timing]") {
    std::unique_ptr<PhraseCore> const made = make_core();
    CoreTiming& core = *made;
    ProcessTiming& writer = core.add_process("writer");
    LoopShape loop;
    loop.depth = 30;
    for (unsigned i = 0; i < 20; ++i) {
        writer.add_writes(core.add_fifo({"fifo", FifoShape::unlimited}));
        loop.writes.push_back({i, i});
    }
    writer.log().enter(writer.add_loop(loop));
    writer.log().iterate(Ports::of(range(0, 20)).number(), 0, 100);
    writer.log().leave();
    core.resolve();
    CHECK(writer.local_time() == 99 + 30);
    CHECK(core.fifo(19).writes() == 100);
}

TEST_CASE("Operations at many ports come out of a file as they were put in", "[ports][events]") {
    Star star;
    star.log_hub();
    std::vector<Operation> const written(star.hub->log().begin(), star.hub->log().begin() + star.hub->log().pending());
    std::string bytes;
    replay::encode_operations(written, bytes);
    std::vector<Operation> read;
    replay::ByteReader reader(bytes);
    replay::OperationCheck check(*star.hub);
    REQUIRE(replay::decode_operations(reader, check, read));
    REQUIRE(read.size() == written.size());
    for (std::size_t i = 0; i < read.size(); ++i)
        CHECK(read[i].code() == written[i].code());

    replay::ByteReader again(bytes);
    replay::OperationCheck smaller(star.core.process(1));  // has a single port
    CHECK_FALSE(replay::decode_operations(again, smaller, read));
}

}  // namespace dataflow::timing::ports_test
