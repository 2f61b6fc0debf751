#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <optional>
#include <string>

#include "chance/chance_design.hpp"
#include "chance/chance_simulation.hpp"
#include "chance/chance_twin.hpp"

namespace random_designs_test {

using namespace faster::chance;
using faster::Engine;

struct Count {
    std::uint64_t designs = 0, stuck = 0, others_stuck = 0, with_attempts = 0, refused = 0, ending = 0, sized = 0;
};

void check(Figures const& found, Figures const& expected, char const* which) {
    INFO(which);
    std::string const difference = first_difference(found, expected);
    if (std::getenv("CHANCE_ALL") != nullptr && !difference.empty()) {
        for (std::string const& line : found.lines)
            UNSCOPED_INFO("found    " << line);
        for (std::string const& line : expected.lines)
            UNSCOPED_INFO("expected " << line);
    }
    CHECK(difference == "");
}

/// Whether attempts of a design come out as they do with other timing, as far as that gets.
bool keeps_outcomes(Figures const& twin, Figures const& other) {
    for (std::size_t i = 0; i < twin.outcomes.size(); ++i)
        if (twin.outcomes[i].compare(0, other.outcomes[i].size(), other.outcomes[i]) != 0)
            return false;
    return true;
}

bool makes_attempts(Figures const& twin) {
    return std::any_of(twin.outcomes.begin(), twin.outcomes.end(), [](std::string const& one) { return !one.empty(); });
}

/// With other timing, a run is retimed right, or refused: never if it makes no attempts, and no loop ends as it likes.
void check_retiming(Outcome const& outcome, Design const& design, Figures const& twin, Figures const& other,
                    Count& count) {
    if (outcome.refusal.empty()) {
        CHECK(keeps_outcomes(twin, other));
        check(outcome.other, other, "retimed");
        return;
    }
    if (outcome.refusal.find(" may end its loop ") != std::string::npos) {
        ++count.ending;
        CHECK(std::any_of(design.processes.begin(), design.processes.end(),
                          [](Process const& process) { return process.decides_trip_counts(); }));
        return;
    }
    CHECK(makes_attempts(twin));
    CHECK_THAT(outcome.refusal, Catch::Matchers::Contains(" without waiting in cycle "));
    ++count.refused;
}

/// With the FIFOs that sizing found, the twin takes what the answer says, and no more than the bound.
void check_sizing(Outcome const& outcome, Design const& design, Count& count) {
    if (!outcome.sized)
        return;
    ++count.sized;
    Design sized = design;
    for (std::size_t i = 0; i < sized.fifos.size(); ++i) {
        if (sized.fifos[i].is_ping_pong)
            continue;
        sized.fifos[i].depth = outcome.sized->depths[i];
        sized.fifos[i].kind = outcome.sized->kinds[i];
    }
    INFO(text_of(sized));
    check(outcome.sized->figures, simulated(sized), "sized");
    CHECK(outcome.sized->figures.total_cycles <= outcome.sized->bound);
}

/// Both engines, recorded or not, retimings as it is, from a file and as another design, against the twin.
void check_design(Design const& design, std::uint64_t seed, Count& count) {
    Design const other = retimed(design, seed);
    CAPTURE(seed, text_of(design));
    Figures const twin = simulated(design), other_twin = simulated(other);
    ++count.designs;
    count.with_attempts += makes_attempts(twin) ? 1U : 0U;
    count.stuck += twin.is_stuck ? 1 : 0;
    count.others_stuck += other_twin.is_stuck ? 1 : 0;
    Figures of_first;
    for (Outcome const& outcome : run_forked(design, other, seed % 4 == 0)) {
        CAPTURE(outcome.engine == Engine::lockstep, outcome.is_recorded);
        CHECK(outcome.error == "");
        check(outcome.run, twin, "run");
        if (of_first.lines.empty())
            of_first = outcome.run;
        check(outcome.run, of_first, "against the first run");
        CHECK(outcome.run.hand_overs == of_first.hand_overs);
        if (!outcome.is_recorded || twin.is_stuck)
            continue;
        check(outcome.as_is, twin, "as it is");
        check(outcome.from_file, twin, "from its event file");
        CHECK(outcome.as_is.hand_overs == of_first.hand_overs);
        INFO(text_of(other));
        check_retiming(outcome, design, twin, other_twin, count);
        check_sizing(outcome, design, count);
    }
}

void check_seed(std::uint64_t seed, Count& count) { check_design(random_design(seed), seed, count); }

TEST_CASE("random designs that once did not agree do") {
    Count count;
    for (std::uint64_t const seed :
         {492UL, 581UL, 679UL, 1545UL, 2893UL, 4396UL, 6467UL, 16146UL, 16226UL, 1795690093635UL, 1795694709530UL,
          1795707857923UL, 1795694711143UL, 1795694733825UL, 1795695928553UL, 1795697282419UL,
          // with a pace
          770019UL, 770160UL, 770421UL, 770453UL, 90003708UL, 90004670UL, 1795732945919UL, 1795732948802UL, 930044UL,
          128002782UL,
          // that get stuck in a step of several tokens
          100145UL,
          // with hand-overs of calls
          501497UL,
          // with calls that do nothing
          438UL, 1594UL, 2782UL, 2980UL})
        check_seed(seed, count);
}

/// Two processes that exchange tokens by a loop each, until one waits for two at once.
Design exchange() {
    Design design;
    design.fifos.resize(3);
    design.fifos[0] = {"asked", 1, 0};
    design.fifos[1] = {"often", 0, 1};
    design.fifos[2] = {"rarely", 0, 1};
    design.fifos[0].write_stage = 2;
    design.fifos[1].write_stage = design.fifos[2].write_stage = 6;
    design.processes.resize(2);
    Accesses const one{0, 1}, all{0, 1, 2};
    std::array<std::vector<Accesses>, 2> const iterations{
        {{one, all, all, all, all, all}, {all, all, all, all, all, one}}};
    for (std::size_t i = 0; i < 2; ++i) {
        Process& process = design.processes[i];
        process.name = i == 0 ? "answers" : "asks";
        process.ends = all;
        process.loops.push_back({"exchange", i == 0 ? 5U : 2U, 1, i == 0 ? 7U : 3U});
        process.program.resize(1);
        process.program.front().kind = Segment::Kind::loop;
        process.program.front().iterations = iterations[i];
    }
    return design;
}

TEST_CASE("who waits for several tokens that an iteration takes later waits for the first") {
    Count count;
    check_design(exchange(), 0, count);
    CHECK(count.stuck == 1);
}

TEST_CASE("nobody waits for stores, however far they run ahead of the memory") {
    Count count;
    std::uint64_t const first = asked("CHANCE_SEED", 1), designs = asked("CHANCE_DESIGNS", 150) / 5;
    for (std::uint64_t seed = first; count.designs < designs; ++seed)
        check_design(storing_ahead(random_design(seed), seed), seed, count);
    WARN(designs << " designs that store ahead from seed " << first << " on: " << count.stuck << " get stuck, "
                 << count.with_attempts << " make attempts, " << count.refused << " retimings of which are refused");
    if (designs >= 30)
        CHECK(count.with_attempts > 0);
}

/// None, if nothing in it can rewind.
std::optional<Design> without_rewinds(Design design) {
    bool can_rewind = false;
    for (Process& process : design.processes)
        for (Loop& loop : process.loops) {
            can_rewind = can_rewind || loop.can_rewind;
            loop.rewinds = false;
        }
    return can_rewind ? std::optional<Design>(design) : std::nullopt;
}

TEST_CASE("what did not rewind is retimed as if it had") {
    Count count;
    std::uint64_t const first = asked("CHANCE_SEED", 1), designs = asked("CHANCE_DESIGNS", 150) / 5;
    for (std::uint64_t seed = first; count.designs < designs; ++seed)
        if (std::optional<Design> const design = without_rewinds(random_design(seed)))
            check_design(*design, seed, count);
}

TEST_CASE("random designs do the same in both engines, retimed, and in a simulation cycle by cycle") {
    std::uint64_t const first = asked("CHANCE_SEED", 1), designs = asked("CHANCE_DESIGNS", 150);
    Count count;
    for (std::uint64_t seed = first; count.designs < designs; ++seed)
        check_seed(seed, count);
    WARN(designs << " random designs from seed " << first << " on: " << count.stuck << " get stuck, retimed "
                 << count.others_stuck << "; " << count.with_attempts << " make attempts, " << count.refused
                 << " retimings of which are refused, " << count.ending << " for ends of loops; " << count.sized
                 << " recordings are sized");
    if (designs >= 150) {
        CHECK(count.stuck > designs / 20);
        CHECK(count.stuck < designs / 2);  // most get to their ends
        CHECK(count.sized > designs / 20);
    }
}

}  // namespace random_designs_test
