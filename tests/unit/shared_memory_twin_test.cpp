#include <catch2/catch.hpp>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/cycle_twin.hpp"
#include "support/plain_config.hpp"
#include "support/random_memory.hpp"
#include "support/random_stimulus.hpp"
#include "support/small_stimulus.hpp"

namespace faster::testing::shared_memory_twin_test {

// Cores of the cycle twin with a memory that they share; window 4 in an image of 8 x 8. Cycles with memory `ideal`:
// "A window of 4 without triangles" and "One small triangle" in cycle_twin_test.cpp.

TwinMemory axi() {
    TwinMemory memory;
    memory.is_axi = true;
    return memory;
}

TwinMemory nothing_limits() {
    TwinMemory memory = axi();
    memory.outstanding = 1000000;
    memory.request_cycles = 0;
    memory.read_latency_ns = 0;
    memory.dram_gb_per_s = 1e6;
    return memory;
}

/// Of three fragments.
Stimulus small_triangles(int samples) {
    Stimulus stimulus = empty_stimulus(4, samples);
    stimulus.triangles = one_small_triangle().triangles;
    for (SampleInput& sample : stimulus.samples)
        sample.triangle_count = 1;
    return stimulus;
}

TwinProcess const& process_of(TwinResult const& result, std::size_t core, ModuleId id) {
    return result.processes.at(core)[index_of(id)];
}

TwinTraffic const& traffic_of(TwinResult const& result, std::size_t core, TwinMaster master) {
    return result.traffic.at(core)[static_cast<std::size_t>(master)];
}

TEST_CASE("With ideal memory nothing is moved", "[memory_twin]") {
    TwinResult const result = run_twin(with_cores(1), empty_stimulus(4, 1));
    CHECK(result.total_cycles == 79);
    CHECK(result.traffic.empty());
    CHECK(result.controller_ps == 0);
}

TEST_CASE("A window without triangles behind a memory, cycle for cycle", "[memory_twin]") {
    // Header: asked for in 0, at the controller in 24, beats 48 .. 51, handed out in 52.
    // ObservationReader: header in 53, loop from 54 on. Rows are 16 bytes apart, 8 bytes each: a beat, a granule. Asked
    // for in 54 .. 57, beats 102 .. 105 (a granule takes less than a cycle). Iterations 103 + i: row k's first, 103 + 4
    // k, finds its beat of 102 + k. Written in 107, sweep from 108 instead of 24: 84 later, 163.
    TwinResult const result = run_twin(with_cores(1), empty_stimulus(4, 1), axi());
    CHECK(result.total_cycles == 79 + 84);
    CHECK(process_of(result, 0, ModuleId::sample_dispatcher).memory_stall == 52);
    CHECK(process_of(result, 0, ModuleId::observation_reader).memory_stall == 49);
    CHECK(process_of(result, 0, ModuleId::vertex_transform).memory_stall == 0);
    CHECK(process_of(result, 0, ModuleId::result_collector).memory_stall == 0);
    // Result: read in 162, asked for in 163.
    CHECK(traffic_of(result, 0, TwinMaster::header) == TwinTraffic{1, 64, 1, 51, 51, 0});
    CHECK(traffic_of(result, 0, TwinMaster::vertex) == TwinTraffic{});
    CHECK(traffic_of(result, 0, TwinMaster::observation) == TwinTraffic{4, 64, 4, 4 * 48, 48, 57});
    CHECK(traffic_of(result, 0, TwinMaster::result) == TwinTraffic{1, 32, 1, 48, 48, 163});
    CHECK(result.port_beats == std::vector<std::uint64_t>{8, 0, 0});
    CHECK(result.controller_ps == 6 * 4444);
}

TEST_CASE("The case by hand does not feel a memory that nothing limits", "[memory_twin]") {
    // docs/memory-model.md: InlierUnit clears for longer than header and first row take.
    for (int samples = 1; samples <= 2; ++samples) {
        Cycles const ideal = 160015 + static_cast<Cycles>(samples - 1) * 160010;
        CHECK(run_twin(with_cores(1), empty_stimulus(200, samples), nothing_limits()).total_cycles == ideal);
        CHECK(run_twin(with_cores(1), empty_stimulus(200, samples), axi()).total_cycles == ideal);
    }
}

TEST_CASE("A memory that nothing limits adds 4 cycles of header and one of the first vertex", "[memory_twin]") {
    Cycles const ideal = run_twin(with_cores(1), small_triangles(1)).total_cycles;
    CHECK(run_twin(with_cores(1), small_triangles(1), nothing_limits()).total_cycles == ideal + 4 + 1);
    // The default one 48 more each: of header and of vertices.
    CHECK(run_twin(with_cores(1), small_triangles(1), axi()).total_cycles == ideal + 5 + 2 * 48);
    // A beat of 64 bytes: a header in one.
    TwinMemory wide = nothing_limits();
    wide.port_bytes = 64;
    CHECK(run_twin(with_cores(1), small_triangles(1), wide).total_cycles == ideal + 1 + 1);
}

TEST_CASE("A deeper pipeline of samples pays for memory once", "[memory_twin]") {
    // docs/memory-model.md: header, the second header's beats, vertex.
    AcceleratorConfig const config = with_cores(1);
    for (int samples = 2; samples <= 5; ++samples) {
        Cycles const ideal = run_twin(config, small_triangles(samples)).total_cycles;
        CHECK(run_twin(config, small_triangles(samples), nothing_limits()).total_cycles == ideal + 4 + 3 + 1);
    }
}

TEST_CASE("The next header's beats come before the first vertex's", "[memory_twin]") {
    // Asked for the cycle after the first was handed out, one before VertexTransform enters its loop: 4 beats, of which
    // one is gone by then.
    AcceleratorConfig const config = with_cores(1);
    TwinResult const one = run_twin(config, small_triangles(1), nothing_limits());
    TwinResult const two = run_twin(config, small_triangles(2), nothing_limits());
    CHECK(two.samples[0].end_cycle == one.samples[0].end_cycle + 3);
}

TEST_CASE("Two cores get their headers one after the other", "[memory_twin]") {
    // The second begins 4444 ps after the first: its beats are 49 .. 52 on a port of its own, else 52 .. 55.
    TwinMemory memory = axi();
    TwinResult const apart = run_twin(with_cores(2), empty_stimulus(4, 2), memory);
    CHECK(process_of(apart, 0, ModuleId::sample_dispatcher).memory_stall == 52);
    CHECK(process_of(apart, 1, ModuleId::sample_dispatcher).memory_stall == 53);
    CHECK(apart.port_beats == std::vector<std::uint64_t>{8, 8, 0});
    memory.ports = 1;
    TwinResult const shared = run_twin(with_cores(2), empty_stimulus(4, 2), memory);
    CHECK(process_of(shared, 0, ModuleId::sample_dispatcher).memory_stall == 52);
    CHECK(process_of(shared, 1, ModuleId::sample_dispatcher).memory_stall == 56);
    CHECK(shared.port_beats == std::vector<std::uint64_t>{16});
    CHECK(shared.samples[1].start_cycle == 57);
}

TEST_CASE("Prefetch asks for headers at once, and for vertices when their header is there", "[memory_twin]") {
    TwinMemory memory = axi();
    memory.prefetch = true;
    TwinResult const result = run_twin(with_cores(1), small_triangles(3), memory);
    // Headers are asked for in 0, 1, 2: beats 48 .. 51, 52 .. 55, 56 .. 59; there in 52, 56, 60, when the dispatcher
    // has come to them in 0, 53, 57.
    CHECK(process_of(result, 0, ModuleId::sample_dispatcher).memory_stall == 52 + 3 + 3);
    // The first sample's vertices are asked for in 53, a cycle before VertexTransform's loop: beats from 101.
    // The second's are asked for in 57, and there when the loop comes to them.
    CHECK(process_of(result, 0, ModuleId::vertex_transform).memory_stall == 102 - 54);
    // Without, the loop waits every time, and the first time for the beats of a header, too.
    memory.prefetch = false;
    CHECK(process_of(run_twin(with_cores(1), small_triangles(3), memory), 0, ModuleId::vertex_transform).memory_stall ==
          3 * 49 + 3);
}

TEST_CASE("On the chip nothing is fetched but headers", "[memory_twin]") {
    TwinMemory memory = axi();
    memory.mesh_on_chip = true;
    memory.observation_on_chip = true;
    TwinResult const result = run_twin(with_cores(1), small_triangles(1), memory);
    Cycles const ideal = run_twin(with_cores(1), small_triangles(1)).total_cycles;
    // Mesh: 24 bytes, 2 beats from 48; image: 128 bytes, 8 beats, asked for a cycle later: 50 .. 57, taken in 58.
    CHECK(result.load_cycles == 59);
    CHECK(result.total_cycles == 59 + 52 + ideal);
    CHECK(traffic_of(result, 0, TwinMaster::vertex).bursts == 0);
    CHECK(traffic_of(result, 0, TwinMaster::observation).bursts == 0);
    CHECK(process_of(result, 0, ModuleId::vertex_transform).memory_stall == 0);
}

TEST_CASE("Cores that share a copy of the observation share its ports", "[memory_twin]") {
    TwinMemory memory = axi();
    memory.observation_on_chip = true;
    AcceleratorConfig config = with_cores(5);
    auto const read_loop = [&] {
        return run_twin(config, empty_stimulus(4, 5), memory).loops.at(0)[index_of(LoopId::read)];
    };
    CHECK(read_loop().ii == 3);  // 5 accesses on 2 ports
    CHECK(read_loop().limited_by == "observation");
    CHECK(read_loop().port_conflict_cycles == 2 * 16);
    memory.observation_copies = 2;
    CHECK(read_loop().ii == 2);
    memory.observation_copies = 3;
    CHECK(read_loop().ii == 1);
    CHECK(read_loop().limited_by.empty());
    config.inlier_unit.sweep_lanes = 4;
    CHECK(read_loop().ii == 4);
    config.memories["observation"].partition = {PartitionType::cyclic, 4, 2};
    CHECK(read_loop().ii == 1);
    memory.observation_on_chip = false;
    CHECK(read_loop().ii == 1);
}

TEST_CASE("With a touched region four words come before the rows, whatever prefetch says", "[memory_twin]") {
    AcceleratorConfig config = with_cores(1);
    config.inlier_unit.sweep_region = SweepRegion::touched;
    TwinMemory memory = axi();
    TwinResult const result = run_twin(config, small_triangles(1), memory);
    REQUIRE_FALSE(result.deadlock);
    // Region: fragments (1, 1) .. (2, 2) and a margin, the window: 4 rows of a beat.
    CHECK(traffic_of(result, 0, TwinMaster::observation).bursts == 4 + 4);
    // The words come behind the 2 beats of the vertices, which were asked for in the same cycle, or one before.
    auto const stall = [&] {
        return process_of(run_twin(config, small_triangles(1), memory), 0, ModuleId::observation_reader).memory_stall;
    };
    CHECK(stall() == 49 + 2 + 49);
    memory.prefetch = true;
    CHECK(stall() == 49 + 1 + 49);
    CHECK(traffic_of(run_twin(config, empty_stimulus(4, 1), memory), 0, TwinMaster::observation).bursts == 4);
    memory.observation_on_chip = true;
    CHECK(traffic_of(run_twin(config, small_triangles(1), memory), 0, TwinMaster::observation).bursts == 4);
}

TEST_CASE("A core in a deadlock does not stop the others", "[memory_twin]") {
    AcceleratorConfig config = with_cores(2);
    config.fifo(FifoId::fragment_depth).depth = 1;
    Stimulus stimulus = small_triangles(2);
    stimulus.samples[1].triangle_count = 0;
    TwinResult const result = run_twin(config, stimulus, axi());
    CHECK(result.deadlock);
    CHECK(result.deadlock_cycle == 97 + 52 + 49);  // alone and without memory: 97
    CHECK(result.samples[0].end_cycle == 0);
    CHECK(result.samples[1].end_cycle > 100);
    CHECK(traffic_of(result, 1, TwinMaster::result).bursts == 1);
}

TEST_CASE("Memory never makes a run faster, and never another one", "[memory_twin]") {
    RandomStimulusOptions stimuli;
    stimuli.window = {4, 16};
    stimuli.samples = {1, 8};
    int slower = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        CAPTURE(seed);
        Stimulus const stimulus = random_stimulus(seed, stimuli);
        AcceleratorConfig config = random_config(seed);
        draw_memory(seed, config);
        TwinMemory const memory = memory_of(config);
        REQUIRE(memory.is_axi);
        TwinResult const ideal = run_twin(config, stimulus, TwinMemory{});
        TwinResult const real = run_twin(config, stimulus);
        REQUIRE_FALSE(ideal.deadlock);
        REQUIRE_FALSE(real.deadlock);
        for (std::size_t i = 0; i < ideal.samples.size(); ++i) {
            CHECK(real.samples[i].counters == ideal.samples[i].counters);
            CHECK(real.samples[i].end_cycle >= ideal.samples[i].end_cycle);
        }
        CHECK(real.total_cycles >= ideal.total_cycles + real.load_cycles);
        slower += real.total_cycles > ideal.total_cycles + 100 ? 1 : 0;
    }
    CHECK(slower > 20);
}

}  // namespace faster::testing::shared_memory_twin_test
