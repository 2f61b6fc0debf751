#include "dataflow/tools/sizing/front.hpp"

#include <algorithm>

namespace dataflow::sizing {

namespace {

SearchOptions options_for(SearchOptions options, bool is_monotone) {
    options.has_repeatable_cuts = !is_monotone;
    return options;
}

FrontPoint point_at(FifoFrame const& frame, RepairedSearch& search, Cycles bound) {
    FrontPoint point;
    point.bound = bound;
    point.found = search.timed(search.cheapest(bound));
    point.primitives = sum_of(point.found.choice, frame.freedoms, frame.weights);
    point.cost = cost_of(point.primitives, frame.weights);
    return point;
}

bool beats(FrontPoint const& a, FrontPoint const& b) {
    bool const is_no_worse = a.cost <= b.cost && a.found.total_cycles <= b.found.total_cycles;
    return is_no_worse && (a.cost < b.cost || a.found.total_cycles < b.found.total_cycles);
}

}  // namespace

RepairedSearch::RepairedSearch(FifoFrame const& frame, CoreTimes& times, Unbounded const& unbounded,
                               SearchOptions const& options)
    : is_monotone_(times.is_monotone()),
      relaxed_(frame, times.relaxed(), unbounded, options_for(options, is_monotone_)),
      exact_(frame, times, unbounded, options_for(options, is_monotone_), &relaxed_) {}

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

std::vector<FrontPoint> front(FifoFrame const& frame, RepairedSearch& search, Cycles unbounded_cycles, Cycles bound,
                              unsigned points, std::function<void()> const& done) {
    std::vector<FrontPoint> all{point_at(frame, search, bound), point_at(frame, search, Cut::deadlock - 1)};
    Cycles const slowest = all.back().found.total_cycles;
    done();
    for (unsigned i = 1; i <= points && slowest > unbounded_cycles; ++i) {
        Cycles const next = unbounded_cycles + (slowest - unbounded_cycles) * (points - i) / points;
        if (all.back().found.total_cycles > next)
            all.push_back(point_at(frame, search, next));
        done();
    }
    std::sort(all.begin(), all.end(),
              [](FrontPoint const& a, FrontPoint const& b) { return a.found.total_cycles > b.found.total_cycles; });
    std::vector<FrontPoint> kept;
    for (FrontPoint const& point : all) {
        bool const is_beaten =
            std::any_of(all.begin(), all.end(), [&point](auto& other) { return beats(other, point); });
        bool const is_there = !kept.empty() && kept.back().found.total_cycles == point.found.total_cycles;
        if (!is_beaten && !is_there)
            kept.push_back(point);
    }
    return kept;
}

}  // namespace dataflow::sizing
