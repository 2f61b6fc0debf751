#include <catch2/catch.hpp>
#include <random>

#include "faster/dataflow_names.hpp"
#include "support/cheaper_choices.hpp"
#include "support/plain_config.hpp"
#include "support/random_memory.hpp"
#include "support/random_stimulus.hpp"
#include "support/recorded_run.hpp"
#include "support/test_run.hpp"

// Sizing FIFOs of cores that share an external memory, where more room may make a run longer.

namespace dataflow::sizing::memory_sizing_test {
using namespace faster;

using Random = std::mt19937_64;

/// A recorded run of a small random workload behind a random memory.
struct Case : faster::testing::RecordedRun {
    using RecordedRun::RecordedRun;

    Sizing size(double percent, unsigned jobs = 1) const {
        SizingOptions options;
        options.within_percent = percent;
        options.front_points = 0;
        options.jobs = jobs;
        return size_fifos(file.run, file.loaded.config, options);
    }
};

struct Most {
    int cores = 3;
    int samples = 6;
    int triangles = 8;
};

/// Most memories are slow, so that cores wait for each other.
Case random_case(std::uint64_t seed, Most const& most = {}) {
    faster::testing::RandomConfigOptions options;
    options.cores = {1, most.cores};
    options.any_region = true;
    AcceleratorConfig config = faster::testing::random_config(seed, options);
    Stimulus const stimulus =
        faster::testing::random_stimulus(seed, faster::testing::sizing_workload(most.samples, most.triangles));
    faster::testing::draw_memory(seed, config);
    faster::testing::adopt(stimulus, config);
    return {stimulus, config};
}

FifoChoice random_fifo(Random& random, FifoGeneration generation) {
    return {random() % 2 == 0 ? FifoKind::shift_register : FifoKind::memory, 2 + random() % 6, generation};
}

TEST_CASE("Behind a shared memory more room may make a run longer, even of one core", "[sizing][memory]") {
    // The first that a search through random cases found, small ones first. Headers get to the observation reader
    // sooner, and so its bursts come before others.
    Case const one = random_case(5, {1, 7, 5});
    Random random(5);
    Choice less = choice_of(one.machine);
    for (FifoChoice& fifo : less)
        fifo = {FifoKind::shift_register, 2 + random() % 8, one.config.fifo_rules};
    Choice more = less;
    std::size_t const fifo = one.machine.fifo("sample_observation");
    CHECK(less[fifo].depth == 2);
    more[fifo].depth = 3;
    CHECK(one.cycles(less) == 6190);
    CHECK(one.cycles(more) == 6244);
    CHECK(one.cycles_on(relaxed(one.machine), more) <= one.cycles_on(relaxed(one.machine), less));
}

TEST_CASE("Where every master has the memory to itself, more room never makes a run longer, nor does sharing shorter",
          "[sizing][memory]") {
    std::size_t shorter = 0;
    std::size_t shared_longer = 0;
    for (std::uint64_t seed = 300; seed < 312; ++seed) {
        Case const one = random_case(seed);
        Machine const alone = relaxed(one.machine);
        Random random(seed);
        for (int i = 0; i < 12; ++i) {
            CAPTURE(seed, i);
            Choice less = choice_of(one.machine);
            Choice more = less;
            for (std::size_t fifo = 0; fifo < less.size(); ++fifo) {
                FifoChoice const a = random_fifo(random, one.config.fifo_rules);
                FifoChoice const b = random_fifo(random, one.config.fifo_rules);
                bool const is_less = a.capacity() <= b.capacity() && a.read_latency() >= b.read_latency();
                less[fifo] = a;
                more[fifo] = is_less ? b : a;
            }
            Cycles const before = one.cycles_on(alone, less);
            Cycles const after = one.cycles_on(alone, more);
            CHECK(after <= before);
            CHECK(before <= one.cycles(less));
            CHECK(after <= one.cycles(more));
            shorter += after < before ? 1U : 0U;
            shared_longer += after < one.cycles(more) ? 1U : 0U;
        }
    }
    CAPTURE(shorter, shared_longer);
    CHECK(shorter > 50);
    CHECK(shared_longer > 50);
}

void check_certificate(Case const& one, Sizing const& sizing) {
    CHECK(sizing.answer.total_cycles <= sizing.bound);
    CHECK(one.cycles(sizing.answer.choice) == sizing.answer.total_cycles);
    CHECK(one.cycles(sizing.unbounded.choice) == sizing.unbounded.total_cycles);
    CHECK(one.cycles(sizing.holds) == sizing.holds_cycles);
    for (CertificateRow const& row : sizing.certificate) {
        CAPTURE(sizing.machine.fifos[row.fifo].name, row.shallower.depth);
        Choice shallower = sizing.answer.choice;
        shallower[row.fifo] = row.shallower;
        CHECK(row.core_cycles > sizing.bound);
        CHECK(one.cycles(shallower) >= row.core_cycles);
    }
}

TEST_CASE("An answer behind a shared memory takes what it says, and nothing below the least cost is within the bound",
          "[sizing][memory]") {
    std::size_t proven = 0;
    std::size_t open = 0;
    std::size_t tried = 0;
    for (std::uint64_t seed = 400; seed < 418; ++seed) {
        double const percent = static_cast<double>(seed % 4) * 3;
        CAPTURE(seed, percent);
        Case const one = random_case(seed);
        Sizing const sizing = one.size(percent);
        check_certificate(one, sizing);
        proven += sizing.is_proven ? 1U : 0U;
        open += sizing.is_proven ? 0U : 1U;
        CHECK(sizing.is_proven == (sizing.answer.cost <= sizing.least_cost + 1e-6));
        faster::testing::CheaperChoices choices(sizing, sizing.least_cost,
                                                [&](auto& choice) { return one.cycles(choice); });
        if (choices.count() > faster::testing::CheaperChoices::most)
            continue;
        CHECK(choices.count_within() == 0);
        tried += choices.count();
    }
    CAPTURE(proven, open, tried);
    CHECK(proven > 2);
    CHECK(open > 1);
    CHECK(tried > 100);
}

TEST_CASE("A run with the depths found behind a shared memory takes as long, whoever looks for them",
          "[sizing][memory]") {
    for (std::uint64_t seed = 430; seed < 434; ++seed) {
        CAPTURE(seed);
        Case const one = random_case(seed);
        Sizing const sizing = one.size(3);
        CHECK(one.size(3, 3).answer.choice == sizing.answer.choice);
        AcceleratorConfig config = one.config;
        MachineSettings const sized = with_choice(one.config, one.machine, sizing.answer.choice);
        for (faster::testing::FifoId const id : faster::testing::fifo_ids)
            config.fifo(id).depth = sized.fifo(id).depth;
        RunStatistics const run = faster::testing::test_run(config, one.stimulus, Engine::lockstep).statistics;
        CHECK(run.total_cycles == sizing.answer.total_cycles);
    }
}

}  // namespace dataflow::sizing::memory_sizing_test
