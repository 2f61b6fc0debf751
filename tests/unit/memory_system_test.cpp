#include "dataflow/core/memory/memory_system.hpp"

#include <catch2/catch.hpp>
#include <cstdint>
#include <deque>
#include <memory>
#include <random>

#include "dataflow/phrases/phrase_core.hpp"
#include "faster/dataflow_names.hpp"

namespace dataflow::timing::memory_system_test {

constexpr Cycles entered = 7;  ///< when the loop is entered
constexpr Cycles depth = 5;    ///< of the loop

ExternalMemory default_shape() {
    ExternalMemory shape;
    shape.latency_ps = 120'000;
    shape.granule_ps = 4444;
    return shape;
}

/// From asking to the first beat.
Cycles reaction(ExternalMemory const& shape) {
    return shape.request_cycles + (shape.latency_ps + shape.period_ps - 1) / shape.period_ps;
}

MemoryEntry range(std::uint64_t address, std::uint64_t tokens, std::uint64_t token_bytes) {
    MemoryBlock block;
    block.address = address;
    block.bytes = tokens * token_bytes;
    block.token_bytes = token_bytes;
    block.tokens = tokens;
    return {0, {block}};
}

/// A core with one process, whose loop takes a token from memory in every iteration and does nothing else.
class Reader {
  public:
    Reader() : process_(core_.add_process("reader")) {
        LoopShape loop;
        loop.name = "read";
        loop.interval = schedule(1, 1, {});
        loop.depth = depth;
        loop.uses_stream = true;
        loop.reads = {{process_.add_stream(core_.add_stream("words", MemoryStream::EntersBy::loop)), 0}};
        process_.add_loop(std::move(loop));
    }

    CoreTiming& core() { return core_; }
    void read(std::uint64_t tokens) {
        process_.log().enter(0);
        process_.log().iterate(Ports::of(process_.stream_port()).number(), 0, static_cast<std::uint32_t>(tokens));
        process_.log().leave();
    }
    void wait(std::uint32_t cycles) { process_.log().wait(cycles); }
    ProcessTiming const& process() const { return process_; }
    Cycles loop_cycles() const { return process_.local_time() - entered; }

  private:
    std::unique_ptr<PhraseCore> made_ = make_core();
    CoreTiming& core_ = *made_;
    ProcessTiming& process_;
};

/// What a loop takes that streams bursts of whole beats, from its entry on.
Cycles cycles_of_loop(ExternalMemory const& shape, std::uint64_t tokens, std::uint64_t token_bytes) {
    Reader reader;
    MemorySystem memory(shape, {{}});
    memory.add_core(reader.core(), true);
    memory.add(0, 0, range(0x1000, tokens, token_bytes));
    reader.wait(entered);
    reader.read(tokens);
    memory.go_on(true);
    CHECK(reader.process().finished());
    CHECK(reader.process().memory_stall_cycles() + tokens - 1 + depth == reader.loop_cycles());
    return reader.loop_cycles();
}

constexpr std::uint64_t beats = 16;  ///< of a burst of 256 bytes
constexpr std::uint64_t granules = 4;

TEST_CASE("A loop that is slower than its port pays the latency once", "[memory]") {
    ExternalMemory const shape = default_shape();
    std::uint64_t const bursts = GENERATE(1U, 2U, 9U);
    CHECK(cycles_of_loop(shape, bursts * beats * 2, 8) == reaction(shape) + bursts * beats * 2 + depth);
    CHECK(cycles_of_loop(shape, bursts * beats, 16) == reaction(shape) + bursts * beats + depth);
}

TEST_CASE("A port brings a beat per cycle", "[memory]") {
    ExternalMemory shape = default_shape();
    std::uint64_t const bursts = 9;
    std::uint64_t const tokens = bursts * beats / 4;
    CHECK(cycles_of_loop(shape, tokens, 64) == reaction(shape) + bursts * beats + depth);
}

TEST_CASE("A slow memory makes its bursts follow each other at its own pace", "[memory]") {
    ExternalMemory shape = default_shape();
    shape.granule_ps = GENERATE(20000U, 40001U, 77777U);
    std::uint64_t const bursts = GENERATE(1U, 2U, 9U);
    Cycles const last =
        ((bursts - 1) * granules * shape.granule_ps + shape.latency_ps + shape.period_ps - 1) / shape.period_ps;
    CHECK(cycles_of_loop(shape, bursts * beats, 16) == shape.request_cycles + last + beats + depth);
}

TEST_CASE("A master that may not ask for more waits for what it has asked for", "[memory]") {
    ExternalMemory shape = default_shape();
    shape.outstanding = GENERATE(1U, 2U);
    std::uint64_t const more = GENERATE(0U, 1U, 2U, 3U, 6U, 7U);  // bursts behind the first
    std::uint64_t const tokens = 2 * beats;                       // of a burst
    Cycles const round = reaction(shape) + tokens + 1;
    REQUIRE(shape.outstanding * tokens < round);
    CHECK(cycles_of_loop(shape, (more + 1) * tokens, 8) ==
          reaction(shape) + tokens + more / shape.outstanding * round + more % shape.outstanding * tokens + depth);
}

TEST_CASE("With nothing to limit it, memory costs the first step one cycle", "[memory]") {
    ExternalMemory shape;
    shape.request_cycles = shape.latency_ps = shape.granule_ps = 0;
    shape.outstanding = 1'000'000;
    CHECK(cycles_of_loop(shape, 3333, 8) == 1 + 3333 - 1 + depth);
}

TEST_CASE("Two cores that ask in one cycle are served in their order", "[memory]") {
    ExternalMemory shape = default_shape();
    shape.ports = GENERATE(1U, 2U);
    std::deque<Reader> readers(2);
    MemorySystem memory(shape, {{}});
    for (Reader& reader : readers) {
        memory.add_core(reader.core(), true);
        reader.wait(entered);
        reader.read(beats);
    }
    memory.add(1, 0, range(0x2000, beats, 16));
    memory.add(0, 0, range(0x1000, beats, 16));
    memory.go_on(true);
    Cycles const later = (granules * shape.granule_ps + shape.latency_ps + shape.period_ps - 1) / shape.period_ps;
    CHECK(readers[0].loop_cycles() == reaction(shape) + beats + depth);
    CHECK(readers[1].loop_cycles() ==
          (shape.ports == 1 ? reaction(shape) + 2 * beats : shape.request_cycles + later + beats) + depth);
    CHECK(memory.controller().largest_queue == 1);
}

TEST_CASE("Ranges are cut at multiples of bursts, and bursts widened to beats", "[memory]") {
    ExternalMemory const shape = default_shape();
    BurstCutter cutter(shape);
    cutter.add(range(0x1000 + 250, 3, 5));  // bytes 250 .. 264
    REQUIRE(cutter.next());
    CHECK(cutter.burst().address == 0x1000 + 240);
    CHECK(cutter.burst().beats == 1);
    CHECK(cutter.burst().granules == 1);
    CHECK(cutter.burst().tokens == 1);
    CHECK(cutter.burst().opens_entry);
    REQUIRE(cutter.next());
    CHECK(cutter.burst().address == 0x1000 + 256);
    CHECK(cutter.burst().beats == 1);
    CHECK(cutter.burst().tokens == 2);
    CHECK(cutter.burst().last_byte_of(0) == 0x1000 + 259);
    CHECK_FALSE(cutter.burst().opens_entry);
    CHECK_FALSE(cutter.next());
}

TEST_CASE("Tokens that lie beside what is fetched need nothing", "[memory]") {
    ExternalMemory const shape = default_shape();
    BurstCutter cutter(shape);
    MemoryBlock block;  // rows of 10 tokens of 4 bytes; bytes 10 .. 29 of the rows 1 and 2 are fetched
    block.address = 0x1000;
    block.bytes = 20;
    block.lead = 10;
    block.token_bytes = 4;
    block.tokens = 10;
    block.rows = 4;
    block.first_row = 1;
    block.fetched_rows = 2;
    block.pitch = 0x400;
    cutter.add({0, {block}});
    REQUIRE(cutter.next());
    CHECK(cutter.take_free_tokens() == 10 + 2);
    CHECK(cutter.burst().tokens == 6);  // 2 .. 7
    CHECK(cutter.burst().last_byte_of(0) == 0x1001);
    CHECK(cutter.burst().last_byte_of(5) == 0x1013);
    REQUIRE(cutter.next());
    CHECK(cutter.take_free_tokens() == 2 + 2);
    CHECK(cutter.burst().address == 0x1400);
    CHECK_FALSE(cutter.next());
    CHECK(cutter.take_free_tokens() == 2 + 10);
}

}  // namespace dataflow::timing::memory_system_test
