#include "sizing/last_that_holds.hpp"

#include <algorithm>
#include <vector>

#include "common/on_threads.hpp"

namespace faster::sizing {

namespace {

using Numbers = std::vector<std::size_t>;

/// What is left: it holds for `yes`, and not for `no`.
struct Bracket {
    std::size_t yes;
    std::size_t no;
    std::size_t open() const { return no - yes - 1; }
};

/// The number of the first of 0 .. count - 1 for which `holds` is false, as it is from there on.
std::size_t first_without(std::size_t count, std::function<bool(std::size_t)> const& holds) {
    std::size_t first = 0;
    for (std::size_t end = count; first < end;) {
        std::size_t const middle = first + (end - first) / 2;
        holds(middle) ? first = middle + 1 : end = middle;
    }
    return first;
}

Numbers evenly(Bracket const& bracket, std::size_t jobs) {
    Numbers numbers;
    std::size_t const probes = std::min(jobs, bracket.open());
    for (std::size_t i = 1; i <= probes; ++i)
        numbers.push_back(bracket.yes + (bracket.no - bracket.yes) * i / (probes + 1));
    return numbers;
}

Numbers near_the_first(Bracket const& bracket, std::size_t jobs) {
    Numbers numbers{bracket.yes + 1};
    std::size_t const step = std::max<std::size_t>(1, bracket.open() / 8);
    for (std::size_t i = 1; i < jobs && bracket.yes + 1 + i * step < bracket.no; ++i)
        numbers.push_back(bracket.yes + 1 + i * step);
    return numbers;
}

void narrow(Bracket& bracket, Numbers const& numbers, std::size_t jobs, Monotone const& monotone) {
    std::vector<char> held(numbers.size());
    on_threads(numbers.size(), jobs, [&](std::size_t i) { held[i] = monotone.holds(numbers[i]) ? 1 : 0; });
    auto const passed = static_cast<std::size_t>(std::find(held.begin(), held.end(), 0) - held.begin());
    if (passed < numbers.size())
        bracket.no = numbers[passed];
    if (passed > 0)
        bracket.yes = numbers[passed - 1];
}

}  // namespace

std::size_t last_that_holds(std::size_t count, unsigned jobs, Monotone const& monotone) {
    auto const known_or = [&](bool otherwise) {
        return first_without(count, [&](std::size_t i) { return monotone.is_known_to_hold(i).value_or(otherwise); });
    };
    std::size_t const at_once = std::max(1U, jobs);
    std::size_t const known = known_or(false);
    Bracket bracket{known == 0 ? 0 : known - 1, known_or(true)};
    if (bracket.open() > 0)
        narrow(bracket, near_the_first(bracket, at_once), at_once, monotone);
    while (bracket.open() > 0)
        narrow(bracket, evenly(bracket, at_once), at_once, monotone);
    return bracket.yes;
}

}  // namespace faster::sizing
