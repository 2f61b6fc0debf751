#include "dataflow/lookup/transition_store.hpp"

#include <algorithm>
#include <array>

#include "dataflow/lookup/numbered_transitions.hpp"

namespace dataflow::timing {

namespace {
constexpr std::size_t most_transitions = NumberedTransitions::numbers;  // about 100 MB with the states between them
constexpr std::uint64_t most_iterations = 0xFFFF;
constexpr std::size_t of_a_sample = 2048;  // transitions, about
}  // namespace

TransitionStore::TransitionStore() {
    briefs_.reserve(of_a_sample);
    tallies_.reserve(of_a_sample);
    ends_.reserve(of_a_sample);
    pieces_.reserve(2 * of_a_sample);
    figures_.reserve(of_a_sample);
    stands_.reserve(4 * of_a_sample);
}

bool TransitionStore::accepts(Transition const& transition) const {
    auto const fits = [](std::uint64_t iterations) { return iterations <= most_iterations; };
    return size() < most_transitions && transition.cycles <= Brief::most_cycles &&
           std::all_of(transition.iterations.begin(), transition.iterations.end(), fits);
}

TransitionStore::Number TransitionStore::add(Transition const& transition) {
    auto const number = static_cast<Number>(size());
    Tally tally{};
    std::transform(transition.iterations.begin(), transition.iterations.end(), tally.iterations.begin(),
                   [](std::uint64_t iterations) { return static_cast<std::uint16_t>(iterations); });
    tally.entered = static_cast<std::uint16_t>(transition.entered);
    briefs_.emplace_back(transition.cycles, transition.entered, !transition.notes.is_empty());
    tallies_.push_back(tally);
    pieces_.push_back(number);
    std::size_t const figures = transition.figures.size();
    FigureBlock const* const kept = kept_figures_.keep(transition.figures.data(), figures);
    figures_.push_back({kept, kept + figures});
    stands_.insert(stands_.end(), transition.stands.begin(), transition.stands.end());
    end();
    if (!transition.notes.is_empty()) {
        places_of_notes_.resize(number + std::size_t{1});
        places_of_notes_[number] = static_cast<std::uint32_t>(notes_.size());
        notes_.push_back(transition.notes);
    }
    if (!transition.trail.empty()) {
        trails_.resize(number + std::size_t{1});
        trails_[number] = transition.trail;
    }
    return number;
}

bool TransitionStore::accepts_sequence(std::vector<Number> const& transitions) const {
    Cycles cycles = 0;
    std::array<std::uint64_t, Transition::most_members> iterations{};
    for (Number const transition : transitions) {
        cycles += briefs_[transition].cycles();
        for (std::size_t m = 0; m < iterations.size(); ++m)
            iterations[m] += tallies_[transition].iterations[m];
    }
    return size() < most_transitions && cycles <= Brief::most_cycles &&
           *std::max_element(iterations.begin(), iterations.end()) <= most_iterations;
}

TransitionStore::Number TransitionStore::add_sequence(std::vector<Number> const& transitions) {
    auto const number = static_cast<Number>(size());
    Brief all;
    Tally sum{};
    for (Number const transition : transitions) {
        all = briefs_[transition].behind(all);
        add(tallies_[transition], sum);
    }
    briefs_.push_back(all);
    tallies_.push_back(sum);
    figures_.push_back({nullptr, nullptr});
    pieces_.insert(pieces_.end(), transitions.begin(), transitions.end());
    end();
    return number;
}

/// Of a transition behind others.
void TransitionStore::add(Tally const& next, Tally& sum) {
    for (std::size_t m = 0; m < sum.iterations.size(); ++m) {
        bool const entered = ((next.entered >> m) & 1U) != 0;
        sum.iterations[m] = static_cast<std::uint16_t>(next.iterations[m] + (entered ? 0 : sum.iterations[m]));
    }
    sum.entered = static_cast<std::uint16_t>(sum.entered | next.entered);
}

std::vector<TrailEvent> const& TransitionStore::trail(Number number) const {
    static std::vector<TrailEvent> const none;
    return number < trails_.size() ? trails_[number] : none;
}

/// Of the transition at hand.
void TransitionStore::end() {
    auto const size_of = [](auto const& all) { return static_cast<std::uint32_t>(all.size()); };
    ends_.push_back({size_of(pieces_), size_of(stands_)});
}

}  // namespace dataflow::timing
