#include <catch2/catch.hpp>
#include <limits>
#include <random>

#include "faster/dataflow_names.hpp"
#include "support/cheaper_choices.hpp"
#include "support/plain_config.hpp"
#include "support/random_stimulus.hpp"
#include "support/recorded_run.hpp"
#include "support/small_stimulus.hpp"
#include "support/test_run.hpp"

namespace dataflow::sizing::sizing_test {
using namespace faster;

using faster::testing::fifo_count;
using faster::testing::fifo_ids;
using faster::testing::FifoId;
using Random = std::mt19937_64;

/// A recorded run of a small random workload on a small random machine, which is printed if a check fails.
struct Case : faster::testing::RecordedRun {
    using RecordedRun::RecordedRun;

    /// With these options, on the configuration that was recorded.
    Sizing size(SizingOptions const& options) const { return size_fifos(file.run, file.loaded.config, options); }
};

/// `free_fifos` of the FIFOs have random kinds, the others are shift registers, whose price steps are large: few
/// combinations cost less than an answer.
Case random_case(std::uint64_t seed, std::size_t free_fifos = fifo_count) {
    faster::testing::RandomConfigOptions machine;
    machine.cores = {1, 3};
    machine.any_region = true;
    AcceleratorConfig config = faster::testing::random_config(seed, machine);
    Random random(seed);
    for (FifoId const id : fifo_ids)
        config.fifo(id).kind = FifoKind::shift_register;
    for (std::size_t i = 0; i < free_fifos; ++i)
        config.fifo(fifo_ids[free_fifos == fifo_count ? i : random() % fifo_count]).kind = std::array<FifoKind, 4>{
            FifoKind::automatic, FifoKind::automatic, FifoKind::shift_register, FifoKind::memory}[random() % 4];
    return {faster::testing::random_stimulus(seed, faster::testing::sizing_workload(6, 8)), config};
}

FifoChoice random_fifo(Random& random, FifoGeneration generation) {
    return {random() % 2 == 0 ? FifoKind::shift_register : FifoKind::memory,
            1 + random() % (random() % 4 == 0 ? 40 : 4), generation};
}

Choice random_choice(Random& random, Case const& of) {
    Choice choice(fifo_count);
    for (FifoChoice& fifo : choice)
        fifo = random_fifo(random, of.config.fifo_rules);
    return choice;
}

bool is_no_better(FifoChoice const& a, FifoChoice const& b) {
    return a.capacity() <= b.capacity() && a.read_latency() >= b.read_latency();
}

SizingOptions within(double percent) {
    SizingOptions options;
    options.within_percent = percent;
    options.front_points = 0;
    return options;
}

/// A token less is a step down unless it makes a shift register of a memory that costs no more.
bool has_token_step(Sizing const& sizing, std::size_t fifo) {
    FifoChoice const& choice = sizing.answer.choice[fifo];
    if (choice.depth == 1)
        return false;
    FifoFreedom const freedom = freedoms_of(sizing.machine)[fifo];
    FifoChoice const shallower = freedom.at_depth(choice.depth - 1);
    auto const cost = [&](FifoChoice const& one) {
        return cost_of(primitives_of(one.kind, one.depth, freedom.bits, sizing.options.weights),
                       sizing.options.weights);
    };
    return shallower.kind == choice.kind || cost(shallower) < cost(choice);
}

void check_certificate(Case const& of, Sizing const& sizing) {
    CHECK(sizing.is_proven);
    CHECK(sizing.answer.total_cycles <= sizing.bound);
    CHECK(of.cycles(sizing.answer.choice) == sizing.answer.total_cycles);
    std::size_t steps = 0;
    for (CertificateRow const& row : sizing.certificate) {
        CAPTURE(fifo_ids.at(row.fifo).name, row.shallower.depth);
        Choice shallower = sizing.answer.choice;
        shallower[row.fifo] = row.shallower;
        CHECK(row.shallower.depth < sizing.answer.choice[row.fifo].depth);
        CHECK(of.cycles(shallower) >= row.core_cycles);
        CHECK((of.config.cores > 1 || of.cycles(shallower) == row.core_cycles));
        CHECK(row.core_cycles > sizing.bound);
        steps += row.is_token_step ? 1U : 0U;
    }
    std::size_t expected = 0;
    for (std::size_t i = 0; i < fifo_count; ++i)
        expected += has_token_step(sizing, i) ? 1U : 0U;
    CHECK(steps == expected);
}

TEST_CASE("More room or less latency never makes a run longer", "[sizing]") {
    std::size_t changed = 0;
    for (std::uint64_t seed = 40; seed < 52; ++seed) {
        Case const one = random_case(seed);
        Random random(seed);
        for (int i = 0; i < 60; ++i) {
            CAPTURE(seed, i);
            Choice const worse = random_choice(random, one);
            Choice better = worse;
            for (std::size_t fifo = 0; fifo < fifo_count; ++fifo)
                if (FifoChoice const other = random_fifo(random, one.config.fifo_rules);
                    is_no_better(worse[fifo], other))
                    better[fifo] = other;
            Cycles const before = one.cycles(worse);
            Cycles const after = one.cycles(better);
            CHECK(after <= before);
            changed += after < before ? 1U : 0U;
        }
    }
    CHECK(changed > 100);
}

TEST_CASE("What does not escape a cut takes as long as the cut says", "[sizing]") {
    std::size_t tried = 0;
    for (std::uint64_t seed = 60; seed < 70; ++seed) {
        Case const one = random_case(seed);
        CoreTimes times(one.file.run, one.machine);
        Random random(seed);
        for (int i = 0; i < 20; ++i) {
            FifoGeneration const rules = one.config.fifo_rules;
            Cut const cut = times.explain(0, random_choice(random, one));
            for (int k = 0; k < 10; ++k) {
                CAPTURE(seed, i, k);
                Choice choice = random_choice(random, one);
                for (FifoChoice& fifo : choice)
                    if (random() % 3 > 0)
                        fifo = {FifoKind::shift_register, 300, rules};
                for (Cut::Member const& member : cut.members)
                    if (member.lets_escape(choice[member.fifo])) {
                        std::uint64_t const capacity = member.capacity > 0 ? member.capacity : 300;
                        std::uint64_t const words = rules == FifoGeneration::vitis_hls ? capacity : capacity - 1;
                        choice[member.fifo] = member.is_slow ? FifoChoice{FifoKind::memory, words, rules}
                                                             : FifoChoice{FifoKind::shift_register, capacity, rules};
                    }
                REQUIRE_FALSE(cut.is_escaped(choice));
                CHECK(times.cycles(0, choice) >= cut.total_cycles);
                ++tried;
            }
        }
    }
    CHECK(tried == 2000);
}

TEST_CASE("Unlimited FIFOs beside others take as long as those with room for everything", "[sizing]") {
    std::size_t deadlocks = 0;
    for (std::uint64_t seed = 70; seed < 80; ++seed) {
        Case const one = random_case(seed);
        CoreTimes times(one.file.run, one.machine);
        Random random(seed);
        for (int i = 0; i < 30; ++i) {
            CAPTURE(seed, i);
            Choice deep = random_choice(random, one);
            Choice unlimited = deep;
            for (std::size_t fifo = 0; fifo < fifo_count; ++fifo)
                if (random() % 2 == 0) {
                    deep[fifo].depth = 5000;
                    unlimited[fifo].depth = timing::FifoShape::unlimited;
                }
            Cycles const cycles = one.cycles(deep);
            CHECK(times.total_cycles(unlimited, 1) == cycles);
            CHECK(times.exceeds(0, unlimited, cycles) == false);
            deadlocks += cycles == Cut::deadlock ? 1U : 0U;
        }
    }
    CHECK(deadlocks < 200);
}

TEST_CASE("What is found does not depend on how many jobs look for it", "[sizing]") {
    for (std::uint64_t seed = 240; seed < 244; ++seed) {
        CAPTURE(seed);
        Case const one = random_case(seed);
        SizingOptions options = within(static_cast<double>(seed % 3) * 4);
        options.front_points = 3;
        options.jobs = 1;
        Sizing const alone = one.size(options);
        for (unsigned const jobs : {2U, 5U}) {
            options.jobs = jobs;
            Sizing const together = one.size(options);
            CHECK(together.answer.choice == alone.answer.choice);
            CHECK(together.unbounded.choice == alone.unbounded.choice);
            REQUIRE(together.front.size() == alone.front.size());
            for (std::size_t i = 0; i < alone.front.size(); ++i)
                CHECK(together.front[i].found.choice == alone.front[i].found.choice);
        }
    }
}

TEST_CASE("Unbounded FIFOs are as fast as those with room for everything", "[sizing]") {
    for (std::uint64_t seed = 80; seed < 90; ++seed) {
        CAPTURE(seed);
        Case const one = random_case(seed);
        Sizing const sizing = one.size(within(0));
        Choice everything = sizing.unbounded.choice;
        for (FifoChoice& fifo : everything)
            fifo.depth = 5000;  // tokens; none of these workloads has more in a FIFO
        CHECK(one.cycles(everything) == sizing.unbounded.total_cycles);
    }
}

TEST_CASE("No combination of depths that costs less is within the bound: all are tried", "[sizing]") {
    std::size_t tried = 0;
    std::size_t cases = 0;
    for (std::uint64_t seed = 106; seed < 114; ++seed) {
        Case const one = random_case(seed, seed < 110 ? 5 : 3);  // long shift registers have many levels
        for (double const percent : {0.0, 4.0, 15.0}) {
            CAPTURE(seed, percent);
            Sizing const sizing = one.size(within(percent));
            CHECK(sizing.is_proven);
            faster::testing::CheaperChoices choices(sizing, sizing.answer.cost,
                                                    [&](auto& choice) { return one.cycles(choice); });
            std::size_t const combinations = choices.count();
            if (combinations == 0 || combinations > faster::testing::CheaperChoices::most)
                continue;
            CHECK(choices.count_within() == 0);
            tried += combinations;
            ++cases;
        }
    }
    CAPTURE(tried, cases);
    CHECK(tried > 1000);
    CHECK(cases > 5);
}

TEST_CASE("Any one FIFO of an answer shallower breaks the bound, and a run takes what the answer says", "[sizing]") {
    for (std::uint64_t seed = 200; seed < 212; ++seed) {
        Case const one = random_case(seed);
        double const percent = static_cast<double>(seed % 4) * 2.5;
        CAPTURE(seed, percent);
        Sizing const sizing = one.size(within(percent));
        check_certificate(one, sizing);
        AcceleratorConfig config = one.config;
        MachineSettings const sized = with_choice(one.config, one.machine, sizing.answer.choice);
        for (FifoId const id : fifo_ids)
            config.fifo(id).depth = sized.fifo(id).depth;  // not the kind: auto is decided by the depth
        RunStatistics const run = faster::testing::test_run(config, one.stimulus, Engine::decoupled).statistics;
        REQUIRE_FALSE(run.deadlocked());
        CHECK(run.total_cycles == sizing.answer.total_cycles);
    }
}

TEST_CASE("FIFOs between two buffers are sized too", "[sizing]") {
    for (std::uint64_t seed = 230; seed < 234; ++seed) {
        CAPTURE(seed);
        Case const plain = random_case(seed);
        AcceleratorConfig config = plain.config;
        bool const has_region = seed % 2 == 1;
        config.inlier_unit.sweep_region = has_region ? SweepRegion::touched : SweepRegion::window;
        config.edge_map.buffers = config.inlier_unit.buffers = 2;
        Case const one(plain.stimulus, config);
        Sizing const sizing = one.size(within(0));
        check_certificate(one, sizing);
        CHECK(sizing.answer.choice[index_of(FifoId::map_full)].depth == 1);  // one token at a time
        CHECK(sizing.answer.choice[index_of(FifoId::depth_free)].depth == 1);
        CHECK(sizing.machine.fifos[index_of(FifoId::map_free)].bits == 1);
        unsigned const corner_bits = sizing.machine.fifos[index_of(FifoId::region)].bits;  // none without one
        CHECK((corner_bits > 0) == has_region);
        CHECK(sizing.machine.fifos[index_of(FifoId::map_full)].bits == 1 + 2 * corner_bits);
        CHECK(sizing.machine.fifos[index_of(FifoId::depth_full)].bits == 33 + 2 * corner_bits);
    }
}

TEST_CASE("Where block RAM is nearly free, a memory may be cheaper than a shift register", "[sizing]") {
    std::size_t memories = 0;
    for (std::uint64_t seed = 220; seed < 226; ++seed) {
        CAPTURE(seed);
        Case const one = random_case(seed);
        SizingOptions options = within(5);
        options.weights.luts_per_ramb36 = 20;
        Sizing const sizing = one.size(options);
        CHECK(sizing.is_proven);
        CHECK(one.cycles(sizing.answer.choice) <= sizing.bound);
        for (CertificateRow const& row : sizing.certificate)
            CHECK(row.breaks(sizing.bound));
        for (std::size_t i = 0; i < fifo_count; ++i)
            memories += fifo_of(one.config, fifo_ids[i]).kind == FifoKind::automatic &&
                                sizing.answer.choice[i] == FifoChoice{FifoKind::memory, 3}
                            ? 1U
                            : 0U;
    }
    CHECK(memories > 0);
}

TEST_CASE("A memory deeper than all tokens of a run is the answer where it costs least", "[sizing]") {
    Case const one = random_case(220);
    SizingOptions options = within(5);
    options.weights.luts_per_ramb36 = 1;
    Sizing const sizing = one.size(options);
    CHECK(sizing.answer.cost <= sizing.unbounded.cost);
    check_certificate(one, sizing);
    bool is_deeper_than_unbounded = false;
    for (std::size_t i = 0; i < fifo_count; ++i)
        is_deeper_than_unbounded =
            is_deeper_than_unbounded || sizing.answer.choice[i].depth > sizing.unbounded.choice[i].depth;
    CHECK(is_deeper_than_unbounded);
}

TEST_CASE("A search that is given up says what it does not know", "[sizing]") {
    std::size_t given_up = 0;
    for (std::uint64_t seed = 205; seed < 213; ++seed) {
        CAPTURE(seed);
        Case const one = random_case(seed);
        SizingOptions options = within(0);
        double const proven = one.size(options).answer.cost;
        options.most_retimings = 1;
        Sizing const sizing = one.size(options);
        CHECK(sizing.answer.total_cycles <= sizing.bound);
        CHECK(sizing.least_cost <= proven + 1e-6);
        CHECK(sizing.answer.cost >= proven - 1e-6);
        for (CertificateRow const& row : sizing.certificate)
            CHECK(row.breaks(sizing.bound));
        given_up += sizing.is_proven ? 0U : 1U;
    }
    CHECK(given_up > 2);
}

TEST_CASE("Points of the front get faster as they cost more, and none is beaten by the answer", "[sizing]") {
    Case const one = random_case(207);
    SizingOptions options = within(3);
    options.front_points = 6;
    Sizing const sizing = one.size(options);
    REQUIRE_FALSE(sizing.front.empty());
    for (std::size_t i = 0; i < sizing.front.size(); ++i) {
        FrontPoint const& point = sizing.front[i];
        CHECK(one.cycles(point.found.choice) == point.found.total_cycles);
        CHECK(point.found.is_proven);
        CHECK_FALSE((sizing.answer.cost < point.cost - 1e-6 && sizing.answer.total_cycles <= point.bound));
        if (i > 0) {
            CHECK(point.cost > sizing.front[i - 1].cost);
            CHECK(point.found.total_cycles < sizing.front[i - 1].found.total_cycles);
        }
    }
    CHECK(sizing.front.back().found.total_cycles <= sizing.unbounded.total_cycles);
}

TEST_CASE("Threads change nothing about a sizing, and a run without samples needs next to nothing", "[sizing]") {
    Case const one = random_case(209);
    SizingOptions options = within(1);
    Sizing const alone = one.size(options);
    options.jobs = 4;
    CHECK(one.size(options).answer.choice == alone.answer.choice);
    Case const nothing(faster::testing::empty_stimulus(4, 0), faster::testing::with_cores(2));
    Sizing const sizing = nothing.size(within(0));
    CHECK(sizing.is_proven);
    CHECK(sizing.answer.total_cycles == 0);
    CHECK(sizing.certificate.empty());
}

TEST_CASE("A bound is a whole number of cycles, percent above", "[sizing]") {
    CHECK(bound_within(0, 11552965) == 11552965);
    CHECK(bound_within(5, 100) == 105);
    CHECK(bound_within(0.1, 3000) == 3003);
    CHECK(bound_within(7, 100) == 107);
    CHECK(bound_within(1, 99) == 99);
}

TEST_CASE("Bounds with which a search would never end or prove nonsense are refused before it begins") {
    Case const small = random_case(1);
    double const nothing = std::numeric_limits<double>::quiet_NaN();
    double const endless = std::numeric_limits<double>::infinity();
    for (double const within : {-1.0, -1e-9, nothing, endless, -endless, 1.1e6}) {
        SizingOptions options;
        options.within_percent = within;
        CHECK_THROWS_WITH(small.size(options), Catch::Contains("within_percent = ") && Catch::Contains("from 0 to"));
    }
    for (double const luts : {0.0, -1.0, nothing, endless}) {
        SizingOptions options;
        options.weights.luts_per_ramb36 = luts;
        CHECK_THROWS_WITH(small.size(options), Catch::Contains("luts_per_ramb36 = "));
    }
    SizingOptions options;
    options.front_points = most_front_points + 1;
    CHECK_THROWS_WITH(small.size(options), Catch::Contains("front_points = 1001"));
}

}  // namespace dataflow::sizing::sizing_test
