#include "timing/transition_store.hpp"

#include <algorithm>

namespace faster::timing {

namespace {
constexpr std::size_t most_transitions = 1U << 17;  // about 60 MB
constexpr Cycles longest_cycles = 0xFFFFFFFF;
constexpr std::uint64_t most_iterations = 0xFFFF;
}  // namespace

bool TransitionStore::accepts(Transition const& transition) const {
    auto const fits = [](std::uint64_t iterations) { return iterations <= most_iterations; };
    return size() < most_transitions && transition.cycles <= longest_cycles &&
           std::all_of(transition.iterations.begin(), transition.iterations.end(), fits);
}

TransitionStore::Number TransitionStore::add(Transition const& transition) {
    auto const number = static_cast<Number>(size());
    Tally tally{};
    std::transform(transition.iterations.begin(), transition.iterations.end(), tally.iterations.begin(),
                   [](std::uint64_t iterations) { return static_cast<std::uint16_t>(iterations); });
    tally.entered = static_cast<std::uint16_t>(transition.entered);
    briefs_.push_back({static_cast<std::uint32_t>(transition.cycles), static_cast<std::uint8_t>(transition.entered),
                       is_notable(transition)});
    tallies_.push_back(tally);
    growth_.insert(growth_.end(), transition.growth.begin(), transition.growth.end());
    growth_ends_.push_back(static_cast<std::uint32_t>(growth_.size()));
    peaks_.insert(peaks_.end(), transition.peaks.begin(), transition.peaks.end());
    peaks_ends_.push_back(static_cast<std::uint32_t>(peaks_.size()));
    stands_.insert(stands_.end(), transition.stands.begin(), transition.stands.end());
    stands_ends_.push_back(static_cast<std::uint32_t>(stands_.size()));
    if (is_notable(transition))
        notes_[number] = {transition.froze, transition.rooms};
    trails_.push_back(transition.trail);
    return number;
}

}  // namespace faster::timing
