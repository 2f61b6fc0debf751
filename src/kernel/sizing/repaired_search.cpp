#include "kernel/sizing/repaired_search.hpp"

namespace faster::sizing {

namespace {

constexpr double cost_rounding = 1e-6;  // LUTs

SearchOptions relaxed_options(SearchOptions options, bool is_monotone) {
    options.has_repeatable_cuts = !is_monotone;
    return options;
}

}  // namespace

RepairedSearch::RepairedSearch(FifoFrame const& frame, CoreTimes& times, Unbounded const& unbounded,
                               SearchOptions const& options)
    : is_monotone_(times.is_monotone()),
      relaxed_(frame, times.relaxed(), unbounded, relaxed_options(options, is_monotone_)),
      exact_(frame, times, unbounded, relaxed_options(options, is_monotone_), &relaxed_) {}

Found RepairedSearch::cheapest(Cycles bound) {
    Found found = relaxed_.cheapest(bound);
    if (is_monotone_ || exact_.is_within(found.choice, bound))
        return found;
    Found repaired = replaced(found, exact_.cheapest(bound).choice);
    repaired.is_repaired = true;
    return repaired;
}

Found RepairedSearch::replaced(Found found, Choice const& choice) const {
    found.choice = choice;
    found.is_proven = exact_.cost_of_choice(choice) <= found.least_cost + cost_rounding;
    found.is_given_up = found.is_given_up && !found.is_proven;
    return found;
}

Found RepairedSearch::shallowest(Found const& found, Cycles bound) {
    if (is_monotone_)
        return relaxed_.shallowest(found, bound);
    if (found.is_repaired)
        return exact_.shallowest(found, bound);
    Found const shallow = relaxed_.shallowest(found, bound);
    return exact_.is_within(shallow.choice, bound) ? timed(shallow) : exact_.shallowest(found, bound);
}

}  // namespace faster::sizing
