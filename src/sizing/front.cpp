#include "sizing/front.hpp"

#include <algorithm>

namespace faster::sizing {

namespace {

FrontPoint point_at(FifoFrame const& frame, Search& search, Cycles bound) {
    FrontPoint point;
    point.bound = bound;
    point.found = search.cheapest(bound);
    point.primitives = sum_of(point.found.choice, frame.bits, frame.weights);
    point.cost = cost_of(point.primitives, frame.weights);
    return point;
}

bool beats(FrontPoint const& a, FrontPoint const& b) {
    bool const is_no_worse = a.cost <= b.cost && a.found.total_cycles <= b.found.total_cycles;
    return is_no_worse && (a.cost < b.cost || a.found.total_cycles < b.found.total_cycles);
}

}  // namespace

std::vector<FrontPoint> front(FifoFrame const& frame, Search& search, Unbounded const& unbounded, unsigned points,
                              std::function<void()> const& done) {
    std::vector<FrontPoint> all{point_at(frame, search, Cut::deadlock - 1)};
    Cycles const slowest = all.front().found.total_cycles;
    done();
    for (unsigned i = 1; i <= points && slowest > unbounded.total_cycles; ++i) {
        Cycles const bound = unbounded.total_cycles + (slowest - unbounded.total_cycles) * (points - i) / points;
        if (all.back().found.total_cycles > bound)
            all.push_back(point_at(frame, search, bound));
        done();
    }
    std::vector<FrontPoint> kept;
    std::copy_if(all.begin(), all.end(), std::back_inserter(kept), [&all](FrontPoint const& point) {
        return std::none_of(all.begin(), all.end(), [&point](FrontPoint const& other) { return beats(other, point); });
    });
    return kept;
}

}  // namespace faster::sizing
