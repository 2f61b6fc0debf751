#include "kernel/sizing/front.hpp"

#include <algorithm>

namespace faster::sizing {

namespace {

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

}  // namespace faster::sizing
