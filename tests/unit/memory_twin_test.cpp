#include "support/memory_twin.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "faster/dataflow_names.hpp"

namespace faster::testing::memory_twin_test {

/// A loop of II 1, entered in some cycle, that takes a token per iteration.
struct Stream {
    std::size_t master = 0;
    Cycles entered = 0;
    std::vector<Cycles> taken;

    void run_cycle(TwinMemoryModel& model, Cycles cycle) {
        TwinMasterModel& source = model.master(master);
        if (cycle == entered)
            source.begin_entry(0, cycle);
        std::size_t const next = taken.size();
        if (cycle < entered || next == source.tokens(0) || source.token_legal_from(0, next) > cycle)
            return;
        source.take(0, next, cycle);
        taken.push_back(cycle);
    }
};

/// Memory with nothing but streams in front of it, in the order that settles ties.
struct Bench {
    explicit Bench(TwinMemory const& memory, double clock_mhz = 200) : model(memory, clock_mhz) {}

    Stream& add(std::size_t port, TwinRanges const& ranges, Cycles entered = 0) {
        Stream& stream = streams.emplace_back();
        stream.master = model.add_master(port, false);
        stream.entered = entered;
        model.master(stream.master).add_entry(ranges);
        return stream;
    }

    void run() {
        auto const ended = [this](Stream const& stream) {
            return stream.taken.size() == model.master(stream.master).tokens(0);
        };
        for (Cycles cycle = 0; !std::all_of(streams.begin(), streams.end(), ended); ++cycle) {
            if (cycle == 1000000)
                FAIL("a stream does not end");
            for (Stream& stream : streams)
                stream.run_cycle(model, cycle);
            model.end_cycle(cycle);
        }
    }

    TwinMemoryModel model;
    std::deque<Stream> streams;
};

/// Cycles of the loop of one stream, of depth 1.
Cycles cycles_of(TwinMemory const& memory, TwinRanges const& ranges, Cycles entered = 7, double clock_mhz = 200) {
    Bench bench(memory, clock_mhz);
    Stream const& stream = bench.add(0, ranges, entered);
    bench.run();
    return stream.taken.back() + 1 - entered;
}

TwinRanges tokens_of(std::size_t count, std::uint64_t bytes, std::uint64_t address = 0) {
    return {{address, std::vector<std::uint64_t>(count, bytes)}};
}

/// What the formulas of docs/memory-model.md speak of, worked out in doubles; all of depth 1.
struct ByHand {
    Cycles m;        ///< bursts
    Cycles b;        ///< beats of a burst
    Cycles t;        ///< tokens of a beat
    double p;        ///< period [ps]
    double g;        ///< granules of a burst x granule_ps
    double latency;  ///< [ps]
    Cycles request;
    Cycles outstanding;

    Cycles r() const { return request + static_cast<Cycles>(std::ceil(latency / p)); }
    bool memory_is_slower() const { return g > static_cast<double>(t * b) * p; }
    bool waits_for_places() const { return outstanding * t * b < r() + t * b + 1; }

    Cycles own_pace() const { return r() + m * t * b + 1; }
    Cycles memory_bound() const {
        return request + static_cast<Cycles>(std::ceil((static_cast<double>(m - 1) * g + latency) / p)) + t * b + 1;
    }
    Cycles outstanding_bound() const {
        Cycles const last = m - 1;
        return r() + t * b + last / outstanding * (r() + t * b + 1) + last % outstanding * t * b + 1;
    }
};

ByHand by_hand(TwinMemory const& memory, Cycles bursts, Cycles tokens_per_beat) {
    double const granules = static_cast<double>(memory.burst_bytes) / 64;
    double const granule_ps = std::round(64000 / (memory.dram_gb_per_s * memory.dram_efficiency));
    return {bursts,
            memory.burst_bytes / memory.port_bytes,
            tokens_per_beat,
            5000,
            granules * granule_ps,
            1000 * memory.read_latency_ns,
            memory.request_cycles,
            memory.outstanding};
}

/// Of whole bursts.
Cycles simulated(TwinMemory const& memory, Cycles bursts, Cycles tokens_per_beat) {
    std::uint64_t const token_bytes = memory.port_bytes / tokens_per_beat;
    return cycles_of(memory, tokens_of(bursts * memory.burst_bytes / token_bytes, token_bytes));
}

TwinMemory nothing_limits() {
    TwinMemory memory;
    memory.is_axi = true;
    memory.outstanding = 1000000;
    memory.request_cycles = 0;
    memory.read_latency_ns = 0;
    memory.dram_gb_per_s = 1e6;
    return memory;
}

TEST_CASE("A stream of vertices pays latency once", "[memory_twin]") {
    // Asked for in 7, at the controller in 31, 155000 ps; ready 120000 ps later, in 55; two vertices in each beat.
    Bench bench{TwinMemory{}};
    Stream const& stream = bench.add(0, mesh_ranges({}, 100), 7);
    bench.run();
    for (std::size_t i = 0; i < 300; ++i)
        CHECK(stream.taken[i] == 56 + i);
    CHECK(simulated({}, 10, 2) == 48 + 10 * 32 + 1);
}

TEST_CASE("With one outstanding burst a stream waits for every one", "[memory_twin]") {
    // docs/memory-model.md: 81 cycles per burst of 32 vertices; three outstanding ones are enough.
    TwinMemory memory;
    memory.outstanding = 1;
    CHECK(simulated(memory, 10, 2) == 9 * 81 + 48 + 32 + 1);
    memory.outstanding = 2;
    CHECK(simulated(memory, 10, 2) == 4 * 81 + 48 + 64 + 1);
    memory.outstanding = 3;
    CHECK(simulated(memory, 10, 2) == 48 + 10 * 32 + 1);
}

TEST_CASE("A slow memory gives a burst per its granules", "[memory_twin]") {
    // 64 bytes per 80 ns: a burst of 256 bytes every 320 ns, 64 cycles; its 32 vertices take 32.
    TwinMemory memory;
    memory.dram_gb_per_s = 0.8;
    memory.dram_efficiency = 1;
    CHECK(simulated(memory, 10, 2) == 48 + 9 * 64 + 32 + 1);
}

TEST_CASE("Tokens of several beats come at the pace of the port", "[memory_twin]") {
    // 64 bytes are 4 beats: 4 tokens per burst, each read the cycle after its last beat.
    Bench bench{TwinMemory{}};
    Stream const& stream = bench.add(0, tokens_of(40, 64), 0);
    bench.run();
    for (std::size_t i = 0; i < 40; ++i)
        CHECK(stream.taken[i] == 48 + 4 * i + 4);
    CHECK(cycles_of({}, tokens_of(40, 64)) == 48 + 160 + 1);  // R + M b + L
}

TEST_CASE("Whole bursts take what the closed forms say", "[memory_twin]") {
    int own = 0, slow = 0, few = 0;
    for (Cycles const tokens_per_beat : {1U, 2U, 4U}) {
        for (std::uint64_t const burst_bytes : {64U, 256U, 1024U}) {
            for (double const gb_per_s : {0.3, 2.0, 19.2}) {
                for (std::uint64_t const outstanding : {1U, 2U, 5U, 16U, 1000U}) {
                    for (double const latency_ns : {0.0, 33.3, 120.0, 1000.0}) {
                        TwinMemory memory;
                        memory.burst_bytes = burst_bytes;
                        memory.dram_gb_per_s = gb_per_s;
                        memory.outstanding = outstanding;
                        memory.read_latency_ns = latency_ns;
                        CAPTURE(tokens_per_beat, burst_bytes, gb_per_s, outstanding, latency_ns);
                        for (Cycles const bursts : {1U, 2U, 7U, 23U}) {
                            ByHand const hand = by_hand(memory, bursts, tokens_per_beat);
                            Cycles const took = simulated(memory, bursts, tokens_per_beat);
                            if (hand.memory_is_slower() && outstanding < bursts)
                                continue;  // both limit: no formula
                            if (hand.memory_is_slower())
                                CHECK(took == hand.memory_bound());
                            else if (hand.waits_for_places())
                                CHECK(took == hand.outstanding_bound());
                            else
                                CHECK(took == hand.own_pace());
                            ++(hand.memory_is_slower() ? slow : hand.waits_for_places() ? few : own);
                        }
                    }
                }
            }
        }
    }
    CHECK(own > 100);
    CHECK(slow > 100);
    CHECK(few > 100);
}

TEST_CASE("Two cores collide at the controller, and on a port for longer", "[memory_twin]") {
    // 4 granules of 4444 ps hold the second burst up by 17776 ps, 4 cycles; 16 beats by 16.
    for (std::size_t const port : {1U, 0U}) {
        Bench bench{TwinMemory{}};
        Stream const& first = bench.add(0, tokens_of(32, 8));
        Stream const& second = bench.add(port, tokens_of(32, 8));
        bench.run();
        CHECK(first.taken.front() == 49);
        CHECK(first.taken.back() == 80);
        CHECK(second.taken.front() == (port == 1 ? 53 : 65));
    }
}

TEST_CASE("Who asks earlier is served earlier, whoever he is", "[memory_twin]") {
    Bench bench{TwinMemory{}};
    Stream const& late = bench.add(0, tokens_of(32, 8), 1);
    Stream const& early = bench.add(0, tokens_of(32, 8), 0);
    bench.run();
    CHECK(early.taken.front() == 49);
    CHECK(late.taken.front() == 65);
}

TEST_CASE("A memory that is behind begins a burst between two cycles", "[memory_twin]") {
    // Bursts of a granule, one per cycle, of 1.5 cycles each: they begin at 0, 7500, 15000, 22500 ps.
    TwinMemory memory = nothing_limits();
    memory.burst_bytes = 64;
    memory.port_bytes = 64;
    memory.dram_gb_per_s = 64.0 / 7.5;
    memory.dram_efficiency = 1;
    Bench bench(memory);
    Stream const& stream = bench.add(0, tokens_of(4, 64));
    bench.run();
    CHECK(stream.taken == std::vector<Cycles>{1, 3, 4, 6});
    CHECK(bench.model.controller_ps() == 30000);
}

TEST_CASE("Periods are rounded to picoseconds", "[memory_twin]") {
    // 300 MHz: 3333 ps. 24 cycles and 120 ns: ceil((79992 + 120000) / 3333) = ceil(60.003...) = 61; read in 62.
    CHECK(cycles_of({}, tokens_of(1, 8), 0, 300) == 62 + 1);
    TwinMemory memory;
    memory.read_latency_ns = 119.988;  // 60 periods of 3333 with the 24
    CHECK(cycles_of(memory, tokens_of(1, 8), 0, 300) == 61 + 1);
}

TEST_CASE("A range is cut at multiples of the burst, and widened to beats", "[memory_twin]") {
    // Bytes 250 .. 529: 250 .. 255 in a beat, 256 .. 511 in 16, 512 .. 529 in 2; granules 1, 4, 1.
    Bench bench{TwinMemory{}};
    Stream const& stream = bench.add(0, tokens_of(35, 8, 250));
    bench.run();
    TwinTraffic const traffic = bench.model.master(0).traffic();
    CHECK(traffic.bursts == 3);
    CHECK(traffic.bytes == 16 * 19);
    CHECK(traffic.granules == 6);
    CHECK(bench.model.port_beats(0) == 19);
    // The first token ends in the second burst, in its first beat: 48 is the beat of the first burst.
    CHECK(stream.taken.front() == 50);
    CHECK(stream.taken.back() == 50 + 34);
}

TEST_CASE("Granules are those that a burst touches, not those that it would fill", "[memory_twin]") {
    auto const granules = [](std::uint64_t address, std::uint64_t bytes, std::uint64_t port_bytes) {
        TwinMemory memory;
        memory.port_bytes = port_bytes;
        Bench bench(memory);
        bench.add(0, tokens_of(1, bytes, address));
        bench.run();
        return bench.model.master(0).traffic().granules;
    };
    CHECK(granules(56, 16, 16) == 2);
    CHECK(granules(64, 64, 16) == 1);
    CHECK(granules(60, 4, 16) == 1);
    CHECK(granules(64, 1, 128) == 2);  // widened to a beat
}

TEST_CASE("Tokens across bursts do not deadlock with one outstanding burst", "[memory_twin]") {
    TwinMemory memory;
    memory.outstanding = 1;
    // The first burst is done with its beat in 48, since no token ends in it; the next is asked for in 49.
    Bench bench(memory);
    Stream const& stream = bench.add(0, tokens_of(35, 8, 250));
    bench.run();
    CHECK(stream.taken.front() == 49 + 48 + 1);
    // Tokens of 400 bytes: 256 + 144 | 112 + 256 + 32 | 224 + 176.
    CHECK(cycles_of(memory, tokens_of(3, 400)) > 5 * 48);
}

TEST_CASE("A token that is not fetched waits for nothing", "[memory_twin]") {
    Bench bench{TwinMemory{}};
    Stream const& stream = bench.add(0, {{128, {0, 0, 8, 0}}, {0, {0, 0}}, {256, {0, 8}}});
    bench.run();
    CHECK(stream.taken == std::vector<Cycles>{0, 1, 49, 50, 51, 52, 53, 54});
    CHECK(bench.model.master(0).traffic().bursts == 2);
}

TEST_CASE("Writes are acknowledged, and take no beat", "[memory_twin]") {
    TwinMemory memory;
    memory.outstanding = 1;
    TwinMemoryModel model(memory, 200);
    std::size_t const reads = model.add_master(0, false);
    std::size_t const writes = model.add_master(0, true);
    model.master(reads).add_entry(tokens_of(1, 8));
    model.master(writes).add_entry(result_ranges(memory, 0));
    model.master(writes).add_entry(result_ranges(memory, 1));
    model.master(reads).begin_entry(0, 1);
    model.master(writes).begin_entry(0, 0);
    model.master(writes).begin_entry(1, 3);
    Cycles cycle = 0;
    for (; cycle <= 48; ++cycle)
        model.end_cycle(cycle);
    CHECK(model.master(reads).token_legal_from(0, 0) == 50);  // as if there were no write
    CHECK(model.master(writes).traffic().bursts == 1);
    model.end_cycle(cycle);  // acknowledged in 48
    CHECK(model.master(writes).traffic().bursts == 2);
    CHECK(model.master(writes).traffic().latency_sum == 48 + 48);
    CHECK(model.master(writes).traffic().bytes == 64);
    CHECK(model.port_beats(0) == 1);
    CHECK(model.is_idle());
}

TEST_CASE("A later entry's bursts are asked for when it begins, not before", "[memory_twin]") {
    Bench bench{TwinMemory{}};
    Stream& stream = bench.add(0, tokens_of(32, 8));
    TwinMasterModel& master = bench.model.master(stream.master);
    master.add_entry(tokens_of(1, 8));
    bench.run();  // ends in 80
    CHECK(bench.model.is_idle());
    master.begin_entry(1, 81);
    CHECK(master.next_ask() == 81);
    bench.model.end_cycle(81);
    CHECK(master.token_legal_from(1, 0) == 81 + 49);
}

TEST_CASE("Headers and results lie by sample, the mesh at its address", "[memory_twin]") {
    TwinMemory const memory;
    CHECK(header_ranges(memory, 3).at(0).address == 0x30000000 + 192);
    CHECK(header_ranges(memory, 3).at(0).token_bytes == std::vector<std::uint64_t>{64});
    CHECK(result_ranges(memory, 3).at(0).address == 0x38000000 + 96);
    CHECK(mesh_ranges(memory, 2).at(0).address == 0x10000000);
    CHECK(mesh_ranges(memory, 2).at(0).token_bytes == std::vector<std::uint64_t>(6, 8));
}

/// A window of 4 at row -1, column 6 of an image of 5 rows and 8 columns.
Stimulus at_the_corner() {
    Stimulus stimulus;
    stimulus.width = 8;
    stimulus.height = 5;
    stimulus.window = 4;
    stimulus.samples.push_back({1, 8, 0, 0});
    return stimulus;
}

TEST_CASE("What lies outside the image is not fetched", "[memory_twin]") {
    TwinMemory memory;
    memory.image_address = 1000;
    TwinRanges const rows = row_ranges(memory, at_the_corner(), 0, {0, 4, 0, 4}, 1);
    REQUIRE(rows.size() == 4);
    CHECK(rows[0].token_bytes == std::vector<std::uint64_t>{0, 0, 0, 0});
    CHECK(rows[1].address == 1000 + 2 * 6);
    CHECK(rows[1].token_bytes == std::vector<std::uint64_t>{2, 2, 0, 0});
    CHECK(rows[3].address == 1000 + 2 * (2 * 8 + 6));
}

TEST_CASE("Whole tokens are fetched, as far as the window goes", "[memory_twin]") {
    TwinMemory memory;
    memory.image_address = 0;
    Stimulus stimulus = at_the_corner();
    stimulus.samples[0] = {2, 3, 0, 0};  // window from (0, 1)
    TwinRanges const rows = row_ranges(memory, stimulus, 0, {1, 2, 2, 4}, 3);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].address == 2 * (8 + 1));  // column 2 is in the token of columns 0 .. 2
    CHECK(rows[0].token_bytes == std::vector<std::uint64_t>{6, 2});
}

TEST_CASE("Table words are those of the window, cut at the image", "[memory_twin]") {
    TwinMemory memory;
    memory.table_address = 0;
    TwinRanges const words = table_ranges(memory, at_the_corner(), 0);  // rows 0 .. 3, columns 6 .. 8
    REQUIRE(words.size() == 4);
    CHECK(words[0].address == 4 * 6);
    CHECK(words[1].address == 4 * 8);
    CHECK(words[2].address == 4 * (3 * 9 + 6));
    CHECK(words[3].address == 4 * (3 * 9 + 8));
}

TEST_CASE("The load is a stream per port", "[memory_twin]") {
    Stimulus stimulus = at_the_corner();
    TwinMemory memory;
    memory.is_axi = true;
    CHECK(load_cycles(memory, 200, stimulus, 2) == 0);
    memory.observation_on_chip = true;
    // 80 bytes: a burst of 5 beats, 48 .. 52, taken in 53.
    CHECK(load_cycles(memory, 200, stimulus, 1) == 54);
    // One copy, one port.
    CHECK(load_cycles(memory, 200, stimulus, 2) == 54);
    // Two copies on two ports: the other's burst has 2 granules, begins 8888 ps later, and comes in 50.
    memory.observation_copies = 2;
    CHECK(load_cycles(memory, 200, stimulus, 2) == 56);
    // One port: both copies listen.
    memory.ports = 1;
    CHECK(load_cycles(memory, 200, stimulus, 2) == 54);
    // 24 bytes of mesh before: 2 beats, 48 and 49; then 50 .. 54.
    memory.mesh_on_chip = true;
    stimulus.samples.push_back({1, 8, 0, 1});
    CHECK(load_cycles(memory, 200, stimulus, 2) == 56);
    stimulus.samples.clear();
    CHECK(load_cycles(memory, 200, stimulus, 2) == 0);
    memory.is_axi = false;
    stimulus = at_the_corner();
    CHECK(load_cycles(memory, 200, stimulus, 2) == 0);
}

TEST_CASE("The memory twin refuses what the page does not allow", "[memory_twin]") {
    auto const with = [](auto change) {
        TwinMemory memory;
        change(memory);
        return memory;
    };
    CHECK_THROWS_AS(TwinMemoryModel(with([](TwinMemory& m) { m.burst_bytes = 48; }), 200), std::invalid_argument);
    CHECK_THROWS_AS(TwinMemoryModel(with([](TwinMemory& m) { m.burst_bytes = 8; }), 200), std::invalid_argument);
    CHECK_THROWS_AS(TwinMemoryModel(with([](TwinMemory& m) { m.port_bytes = 2; }), 200), std::invalid_argument);
    CHECK_THROWS_AS(TwinMemoryModel(with([](TwinMemory& m) { m.outstanding = 0; }), 200), std::invalid_argument);
    CHECK_THROWS_AS(TwinMemoryModel(with([](TwinMemory& m) { m.ports = 0; }), 200), std::invalid_argument);
    CHECK_THROWS_AS(TwinMemoryModel({}, 3e6), std::invalid_argument);
}

}  // namespace faster::testing::memory_twin_test
