#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "dataflow/core/time/fifo_timing.hpp"
#include "dataflow/core/time/initiation_interval.hpp"
#include "dataflow/core/time/process_timing.hpp"
#include "dataflow/phrases/phrase_core.hpp"
#include "faster/dataflow_names.hpp"

namespace dataflow::timing::timing_test {

FifoShape shape(char const* name, std::uint64_t capacity, Cycles read_latency = 1) {
    FifoShape result;
    result.name = name;
    result.capacity = capacity;
    result.read_latency = read_latency;
    return result;
}

LoopShape loop(Cycles ii, Cycles depth, std::vector<LoopAccess> writes) {
    LoopShape result;
    result.name = "loop";
    result.interval = schedule(ii, 1, {});
    result.depth = depth;
    result.writes = std::move(writes);
    return result;
}

std::uint8_t bit(unsigned port) { return static_cast<std::uint8_t>(1U << port); }

/// Logs `count` reads of the only port, `pace` cycles apart unless they wait, after `first` cycles.
void log_reads(ProcessTiming& process, unsigned port, std::uint32_t first, unsigned count, std::uint32_t pace) {
    process.log().wait(first);
    for (unsigned i = 0; i < count; ++i) {
        process.log().stamp();
        process.log().step(bit(port), pace);
    }
}

void log_loop(ProcessTiming& process, unsigned number, std::uint8_t ports, std::uint32_t count) {
    process.log().enter(number);
    process.log().iterate(ports, 0, count);
    process.log().leave();
}

/// As `decoupled` does it (all at once) or as `lockstep` does (one step at a time, of the process ready first).
void run(CoreTiming& core, std::vector<ProcessTiming*> const& processes, bool one_step_at_a_time) {
    for (bool moved = one_step_at_a_time; moved;) {
        moved = false;
        ProcessTiming* first = nullptr;
        for (ProcessTiming* process : processes)
            if (process->front() == ProcessTiming::Status::ready &&
                (first == nullptr || process->front_cycle() < first->front_cycle()))
                first = process;
        if (first != nullptr) {
            first->commit_front();
            moved = true;
        }
    }
    core.resolve();
    REQUIRE(core.blocked().empty());
}

TEST_CASE("The largest occupancy of what is handed over without delay is that at the end of a cycle", "[timing]") {
    for (unsigned seed = 1; seed <= 500; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        FifoShape shape;
        shape.capacity = 1 + random() % 4;
        shape.read_latency = shape.room_latency = 0;
        FifoTiming fifo(shape);
        std::vector<Cycles> writes, reads;
        std::uint64_t largest = 0;
        while (reads.size() < 40) {
            bool const may_write = fifo.known_writes() > 0 && writes.size() < 40;
            Cycles const pause = random() % 3;
            if (may_write && (fifo.known_reads() == 0 || random() % 2 == 0)) {
                writes.push_back(std::max(writes.empty() ? 0 : writes.back() + pause, fifo.earliest_write()));
                fifo.write(writes.back());
            } else {
                reads.push_back(std::max(reads.empty() ? 0 : reads.back() + pause, fifo.earliest_read()));
                fifo.read(reads.back());
            }
        }
        for (std::size_t n = 0; n < writes.size(); ++n)
            for (std::size_t k = 0; k <= n; ++k)
                largest = std::max<std::uint64_t>(largest, reads[k] > writes[n] ? n - k + 1 : 0);
        CHECK(fifo.max_occupancy() == largest);
    }
}

TEST_CASE("A FIFO access is legal from the cycle its other side allows", "[timing]") {
    FifoTiming fifo(shape("fifo", 2, 2));
    CHECK(fifo.known_reads() == 0);
    REQUIRE(fifo.known_writes() == 2);
    CHECK(fifo.earliest_write(0) == 0);
    CHECK(fifo.earliest_write(1) == 0);

    fifo.write(5);
    REQUIRE(fifo.known_reads() == 1);
    CHECK(fifo.earliest_read() == 7);  // s + Lf
    CHECK(fifo.known_writes() == 1);
    fifo.write(9);
    CHECK(fifo.known_writes() == 0);  // full: the third write waits for the first read
    CHECK(fifo.earliest_read(1) == 11);

    fifo.read(20);
    REQUIRE(fifo.known_writes() == 1);
    CHECK(fifo.earliest_write() == 21);  // r + 1
    CHECK(fifo.known_reads() == 1);
    fifo.write(21);
    fifo.read(21);
    CHECK(fifo.earliest_write() == 22);
    CHECK(fifo.earliest_read() == 23);
    CHECK(fifo.writes() == 3);
    CHECK(fifo.reads() == 2);
    CHECK(fifo.max_occupancy() == 2);
}

TEST_CASE("A token read in the cycle in which another is written never makes two", "[timing]") {
    FifoTiming fifo(shape("fifo", 4));
    for (Cycles cycle = 0; cycle < 10; ++cycle) {
        fifo.write(cycle);
        fifo.read(cycle + 1);
    }
    CHECK(fifo.max_occupancy() == 1);

    FifoTiming ahead(shape("fifo", 4));  // the same with the writer ahead of the reader
    for (Cycles cycle = 0; cycle < 4; ++cycle)
        ahead.write(cycle);
    for (Cycles cycle = 0; cycle < 4; ++cycle)
        ahead.read(cycle + 1);
    CHECK(ahead.max_occupancy() == 1);
}

TEST_CASE("The stages of a squeezing pipeline are room in front of its FIFO", "[timing]") {
    FifoShape pipeline = shape("area_reciprocal", 1);
    pipeline.issue_latency = 3;
    FifoTiming fifo(pipeline);
    REQUIRE(fifo.known_writes() == 4);
    for (Cycles cycle = 10; cycle < 14; ++cycle)
        fifo.write(cycle);
    CHECK(fifo.known_writes() == 0);
    CHECK(fifo.earliest_read() == 10 + 3 + 1);
    fifo.read(30);
    CHECK(fifo.earliest_write() == 31);
    CHECK(fifo.max_occupancy() == 1);  // what is still in the pipeline does not count
}

/// A unit of some stages that reads numbers which are there from cycle 0 on, and whose results wait for a reader.
struct FlushingUnit {
    std::unique_ptr<PhraseCore> const made = make_core();
    CoreTiming& core = *made;
    FifoTiming& in = core.add_fifo(shape("in", 100));
    FifoTiming& out;
    ProcessTiming& unit = core.add_process("unit");

    FlushingUnit(Cycles stages, std::uint64_t capacity)
        : out(core.add_fifo([&] {
              FifoShape behind = shape("out", capacity);
              behind.flushing_stages = stages;
              return behind;
          }())) {
        unit.add_reads(in);
        unit.add_writes(out);
    }
    /// Reads what can be read from a cycle on, which yields something.
    void divide(Cycles written) {
        in.write(written);
        unit.log().step(bit(0), 0);
        unit.log().step(bit(1), 0);
        unit.log().wait(1);
        core.resolve();
    }
};

TEST_CASE("A flushing pipeline freezes with its bubbles while there is no room behind it", "[timing]") {
    FlushingUnit machine(4, 1);
    for (Cycles const written : std::vector<Cycles>{9, 11, 14})  // read in 10, 12 and 15
        machine.divide(written);
    CHECK(machine.out.writes() == 1);  // in 14
    CHECK(machine.out.known_reads() == 1);
    CHECK(machine.out.earliest_read() == 15);
    CHECK(machine.unit.local_time() == 16);
    CHECK(machine.in.empty_stall_cycles() == 13);  // all but the three steps that read

    machine.out.read(30);  // the second was due in 16, and gets its place in 31
    machine.core.resolve();
    CHECK(machine.out.earliest_read() == 32);
    CHECK(machine.out.full_stall_cycles() == 15);

    machine.out.read(32);  // the third was three steps behind it, and still is
    machine.core.resolve();
    CHECK(machine.out.earliest_read() == 35);
    CHECK(machine.out.full_stall_cycles() == 15);

    machine.divide(16);  // could have been read in 17, but everything stood still from 16 to 31
    CHECK(machine.unit.local_time() == 32);
    CHECK(machine.in.empty_stall_cycles() == 13);
    CHECK(machine.unit.end() == 32);
}

TEST_CASE("A result that waits behind a flushing pipeline says so when everything stands still", "[timing]") {
    FlushingUnit machine(4, 1);
    machine.divide(9);
    machine.divide(11);
    std::vector<BlockedProcess> const waits = machine.core.blocked();
    REQUIRE(waits.size() == 1);
    CHECK(waits[0].fifo == "out");
    CHECK(waits[0].to_write);
    CHECK(waits[0].occupancy == 1);
    CHECK(waits[0].since == 13);
}

TEST_CASE("An unlimited FIFO is as one with room for everything, however far its writer gets ahead", "[timing]") {
    for (unsigned const count : {3U, 700U, 1500U, 9000U})
        for (bool const in_loops : {false, true}) {
            CAPTURE(count, in_loops);
            std::vector<std::vector<Cycles>> stamps;
            std::vector<Cycles> stalls;
            for (std::uint64_t const capacity : {std::uint64_t{20'000}, FifoShape::unlimited}) {
                std::unique_ptr<PhraseCore> const made = make_core();
                CoreTiming& core = *made;
                FifoTiming& tokens = core.add_fifo(shape("tokens", capacity));
                FifoTiming& go = core.add_fifo(shape("go", 1));
                ProcessTiming& writer = core.add_process("writer");
                ProcessTiming& reader = core.add_process("reader");
                unsigned const written = writer.add_writes(tokens);
                unsigned const said = writer.add_writes(go);
                unsigned const heard = reader.add_reads(go);
                unsigned const read = reader.add_reads(tokens);
                unsigned const writes = writer.add_loop(loop(1, 3, {{written, 0}}));
                unsigned const reads = reader.add_loop(loop(2, 2, {}));
                for (int round = 0; round < 3; ++round) {
                    reader.log().step(bit(heard), 1);  // the reader begins when all has been written
                    if (in_loops) {
                        log_loop(writer, writes, bit(written), count);
                        log_loop(reader, reads, bit(read), count);
                    } else {
                        for (unsigned i = 0; i < count; ++i)
                            writer.log().step(bit(written), i % 3);
                        log_reads(reader, read, 0, count, 2);
                    }
                    reader.log().stamp();
                    writer.log().step(bit(said), 5);
                }
                core.resolve();
                REQUIRE(core.blocked().empty());
                CHECK(tokens.writes() == 3 * count);
                CHECK(tokens.reads() == 3 * count);
                stamps.push_back(reader.stamps());
                stalls.push_back(reader.empty_stall_cycles() + writer.full_stall_cycles());
            }
            CHECK(stamps[0] == stamps[1]);
            CHECK(stalls[0] == stalls[1]);
        }
    FifoTiming limited(shape("limited", 2));
    CHECK_THROWS(limited.keep_more());
}

TEST_CASE("The initiation interval is the hardest demand", "[timing]") {
    InitiationInterval const sweep = schedule(1, 1, {{"depth_buffer", 5, 2}});
    CHECK(sweep.ports == 3);
    CHECK(sweep.achieved == 3);
    CHECK(sweep.port_conflict_per_iteration == 2);
    CHECK(sweep.recurrence_per_iteration == 0);
    CHECK(sweep.limited_by == "depth_buffer");

    InitiationInterval const enough = schedule(1, 1, {{"depth_buffer", 5, 5}});
    CHECK(enough.achieved == 1);
    CHECK(enough.limited_by.empty());
    CHECK(enough.bram == "depth_buffer");

    InitiationInterval const recurrence = schedule(2, 4, {{"depth_buffer", 5, 2}});
    CHECK(recurrence.achieved == 4);
    CHECK(recurrence.port_conflict_per_iteration == 0);
    CHECK(recurrence.recurrence_per_iteration == 2);
    CHECK(recurrence.limited_by == "recurrence");

    InitiationInterval const both = schedule(1, 2, {{"depth_buffer", 5, 1}});
    CHECK(both.achieved == 5);
    CHECK(both.port_conflict_per_iteration == 3);
    CHECK(both.recurrence_per_iteration == 1);
    CHECK(both.limited_by == "depth_buffer");

    InitiationInterval const relaxed = schedule(6, 2, {{"depth_buffer", 5, 1}});
    CHECK(relaxed.achieved == 6);
    CHECK(relaxed.port_conflict_per_iteration == 0);
    CHECK(relaxed.recurrence_per_iteration == 0);
    CHECK(relaxed.limited_by.empty());

    CHECK(schedule(1, 1, {}).achieved == 1);
    CHECK(schedule(1, 1, {{"edge_map", 2, 1}, {"object_map", 2, 1}}).limited_by == "edge_map");
    CHECK(schedule(1, 1, {{"edge_map", 2, 2}, {"object_map", 2, 1}}).limited_by == "object_map");
}

TEST_CASE("A pipelined loop whose tokens leave in one stage", "[timing]") {
    // Loop II=1 L=3 Lw=2 over 5 iterations; C=2, Lf=1; the reader reads every 4th cycle.
    // r: 3 (2 + 1), 7, 11, 15, 19. s: 2, 3, 4 (r0 + 1: just in time), 8 (r1 + 1: 3 late), 12 (r2 + 1: 3 late).
    // The last write is in the loop's last step: it ends at 13.
    bool const one_step_at_a_time = GENERATE(false, true);
    std::unique_ptr<PhraseCore> const made = make_core();
    CoreTiming& core = *made;
    FifoTiming& fifo = core.add_fifo(shape("fifo", 2));
    ProcessTiming& writer = core.add_process("writer");
    ProcessTiming& reader = core.add_process("reader");
    unsigned const out = writer.add_writes(fifo);
    unsigned const in = reader.add_reads(fifo);
    log_loop(writer, writer.add_loop(loop(1, 3, {{out, 2}})), bit(out), 5);
    log_reads(reader, in, 0, 5, 4);
    run(core, {&writer, &reader}, one_step_at_a_time);

    CHECK(fifo.writes() == 5);
    CHECK(fifo.reads() == 5);
    CHECK(fifo.full_stall_cycles() == 6);
    CHECK(fifo.empty_stall_cycles() == 3);
    CHECK(fifo.max_occupancy() == 2);
    CHECK(writer.local_time() == 13);
    CHECK(reader.local_time() == 23);
    CHECK(reader.stamps() == std::vector<Cycles>{0, 7, 11, 15, 19});  // before each read
    CHECK(writer.loop_counters(0).entries == 1);
    CHECK(writer.loop_counters(0).iterations == 5);
}

TEST_CASE("A pipelined loop freezes with tokens of several iterations in it", "[timing]") {
    // Loop II=1 L=3 over 4 iterations: a leaves in stage 0, b in stage 2. Steps: a0; a1; a2 b0; a3 b1; b2; b3.
    // b holds one token and is first read at 10.
    //   a0 0, a1 1, a2 and b0 2; a3 and b1 wait for r0 + 1 = 11, 8 late; r1 = 12: b2 at 13, 1 late; r2 = 14: b3 at 15,
    //   1 late. The loop ends at 16: 6 steps and 10 cycles of waiting, all charged to b.
    // a is read at 1, 2, 3 and, 8 late, 12.
    bool const one_step_at_a_time = GENERATE(false, true);
    std::unique_ptr<PhraseCore> const made = make_core();
    CoreTiming& core = *made;
    FifoTiming& a = core.add_fifo(shape("a", 2));
    FifoTiming& b = core.add_fifo(shape("b", 1));
    ProcessTiming& writer = core.add_process("writer");
    ProcessTiming& reader_a = core.add_process("reader_a");
    ProcessTiming& reader_b = core.add_process("reader_b");
    unsigned const out_a = writer.add_writes(a);
    unsigned const out_b = writer.add_writes(b);
    unsigned const in_a = reader_a.add_reads(a);
    unsigned const in_b = reader_b.add_reads(b);
    unsigned const number = writer.add_loop(loop(1, 3, {{out_a, 0}, {out_b, 2}}));
    log_loop(writer, number, static_cast<std::uint8_t>(bit(out_a) | bit(out_b)), 4);
    log_reads(reader_a, in_a, 0, 4, 1);
    log_reads(reader_b, in_b, 10, 4, 1);
    run(core, {&writer, &reader_a, &reader_b}, one_step_at_a_time);

    CHECK(a.full_stall_cycles() == 0);
    CHECK(a.empty_stall_cycles() == 1 + 8);
    CHECK(a.max_occupancy() == 1);
    CHECK(b.full_stall_cycles() == 8 + 1 + 1);
    CHECK(writer.local_time() == 16);
    CHECK(reader_a.local_time() == 13);
    CHECK(reader_b.local_time() == 17);
}

TEST_CASE("An unaligned loop without stalls takes (n - 1) II + L", "[timing]") {
    // II=2 L=5, a in stage 0, b in stage 3: a at 0, 2, 4, b at 3, 5, 7; ends at 2 * 2 + 5 = 9.
    bool const one_step_at_a_time = GENERATE(false, true);
    std::unique_ptr<PhraseCore> const made = make_core();
    CoreTiming& core = *made;
    FifoTiming& a = core.add_fifo(shape("a", 9));
    FifoTiming& b = core.add_fifo(shape("b", 9));
    ProcessTiming& writer = core.add_process("writer");
    ProcessTiming& reader = core.add_process("reader");
    unsigned const out_a = writer.add_writes(a);
    unsigned const out_b = writer.add_writes(b);
    unsigned const in_a = reader.add_reads(a);
    unsigned const in_b = reader.add_reads(b);
    unsigned const number = writer.add_loop(loop(2, 5, {{out_a, 0}, {out_b, 3}}));
    log_loop(writer, number, static_cast<std::uint8_t>(bit(out_a) | bit(out_b)), 3);
    for (int i = 0; i < 3; ++i) {  // both together: at 4, 6, 8, waiting for a first, then for b
        reader.log().step(static_cast<std::uint8_t>(bit(in_a) | bit(in_b)), 1);
        reader.log().stamp();
    }
    run(core, {&writer, &reader}, one_step_at_a_time);

    CHECK(writer.local_time() == 9);
    CHECK(reader.stamps() == std::vector<Cycles>{5, 7, 9});
    CHECK(a.empty_stall_cycles() == 1);
    CHECK(b.empty_stall_cycles() == 3 + 1 + 1);
}

TEST_CASE("Accesses that nobody answers are waits, with both ends named", "[timing]") {
    std::unique_ptr<PhraseCore> const made = make_core();
    CoreTiming& core = *made;
    FifoTiming& fifo = core.add_fifo(shape("fifo", 1));
    ProcessTiming& writer = core.add_process("writer");
    ProcessTiming& reader = core.add_process("reader");
    unsigned const out = writer.add_writes(fifo);
    reader.add_reads(fifo);
    writer.log().step(bit(out), 3);
    writer.log().step(bit(out), 1);
    core.resolve();
    std::vector<BlockedProcess> const waits = core.blocked();
    REQUIRE(waits.size() == 1);
    CHECK(waits[0].process == "writer");
    CHECK(waits[0].fifo == "fifo");
    CHECK(waits[0].to_write);
    CHECK(waits[0].occupancy == 1);
    CHECK(waits[0].capacity == 1);
    CHECK(waits[0].since == 3);
    CHECK(waits[0].other == "reader");
}

}  // namespace dataflow::timing::timing_test
