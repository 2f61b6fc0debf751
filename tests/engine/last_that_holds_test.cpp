#include "dataflow/tools/sizing/last_that_holds.hpp"

#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <mutex>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include "faster/dataflow_names.hpp"

namespace dataflow::sizing::last_that_holds_test {

/// Margins that never rise, of which those asked for are known.
struct Margins {
    std::vector<double> margins;
    std::mutex mutex;
    std::set<std::size_t> asked;

    Monotone monotone() {
        Monotone monotone;
        monotone.holds = [this](std::size_t i, Monotone::IsObsolete const& /*is_obsolete*/) -> std::optional<bool> {
            std::lock_guard<std::mutex> const lock(mutex);
            asked.insert(i);
            return margins[i] >= 0;
        };
        monotone.is_known_to_hold = [this](std::size_t i) -> std::optional<bool> {
            for (std::size_t const known : asked)
                if (margins[known] >= 0 ? i <= known : i >= known)
                    return margins[known] >= 0;
            return std::nullopt;
        };
        return monotone;
    }

    std::size_t last() const {
        auto const none = [](double margin) { return margin < 0; };
        return static_cast<std::size_t>(std::find_if(margins.begin(), margins.end(), none) - margins.begin()) - 1;
    }
};

std::vector<double> random_margins(std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::size_t const count = 1 + random() % (seed % 2 == 0 ? 8 : 3000);
    std::size_t const bend = random() % count;
    auto const power = static_cast<double>(1 + random() % 3);
    auto const step = static_cast<double>(random() % 3);
    std::vector<double> margins;
    for (std::size_t i = 0; i < count; ++i) {
        double const beyond = i < bend ? 0 : static_cast<double>(i - bend);
        std::size_t const steps = i / 3;
        margins.push_back(std::floor(static_cast<double>(seed % 50) - std::pow(beyond, power) / 7) -
                          step * static_cast<double>(steps) * 3);
    }
    return margins;
}

TEST_CASE("The last that holds is found whatever the margins are, with any number of jobs", "[sizing]") {
    for (std::uint64_t seed = 1; seed < 400; ++seed)
        for (unsigned const jobs : {0U, 1U, 2U, 5U}) {
            CAPTURE(seed, jobs);
            Margins margins;
            margins.margins = random_margins(seed);
            REQUIRE(last_that_holds(margins.margins.size(), jobs, margins.monotone()) == margins.last());
            REQUIRE(margins.asked.size() <= 40 + 5 * jobs);
        }
}

TEST_CASE("Two at once ask no more than twice what one alone does, and twice near the first", "[sizing]") {
    for (std::size_t const bend : {0U, 700U, 9000U}) {
        CAPTURE(bend);
        Margins margins;
        for (std::size_t i = 0; i < 16384; ++i)
            margins.margins.push_back(20'000 - 37.5 * static_cast<double>(i < bend ? 0 : i - bend));
        REQUIRE(last_that_holds(margins.margins.size(), 2, margins.monotone()) == margins.last());
        CHECK(margins.asked.size() <= 2 + 2 * 14);
    }
}

TEST_CASE("What others have told meanwhile is obsolete, and may be given up", "[sizing]") {
    constexpr std::size_t last = 1000;
    std::atomic<std::size_t> calls = 0;
    std::atomic<std::size_t> given_up = 0;
    Monotone monotone;
    monotone.holds = [&](std::size_t i, Monotone::IsObsolete const& is_obsolete) -> std::optional<bool> {
        if (calls++ > 0)
            return i <= last;
        while (!is_obsolete())  // the first never gets done
            std::this_thread::yield();
        ++given_up;
        return std::nullopt;
    };
    monotone.is_known_to_hold = [](std::size_t) { return std::nullopt; };
    CHECK(last_that_holds(16384, 2, monotone) == last);
    CHECK(given_up == 1);
}

TEST_CASE("What is thrown where it is worked out ends the search of all", "[sizing]") {
    Monotone monotone;
    monotone.holds = [](std::size_t i, Monotone::IsObsolete const& /*is_obsolete*/) -> std::optional<bool> {
        if (i > 100)
            throw std::runtime_error("broken");
        return true;
    };
    monotone.is_known_to_hold = [](std::size_t) { return std::nullopt; };
    for (unsigned const jobs : {1U, 2U, 5U})
        CHECK_THROWS_WITH(last_that_holds(4096, jobs, monotone), "broken");
}

}  // namespace dataflow::sizing::last_that_holds_test
