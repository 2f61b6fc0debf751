#include "dataflow/tools/compare/comparison.hpp"

#include <algorithm>
#include <cstdlib>

namespace dataflow::runs {

std::int64_t Change::difference() const {
    return static_cast<std::int64_t>(b.value_or(0)) - static_cast<std::int64_t>(a.value_or(0));
}

std::optional<double> Change::percent() const {
    return percent_of(static_cast<double>(a.value_or(0)), static_cast<double>(b.value_or(0)));
}

void sort_by_difference(std::vector<Change>& changes) {
    std::stable_sort(changes.begin(), changes.end(), [](Change const& left, Change const& right) {
        return std::abs(left.difference()) > std::abs(right.difference());
    });
}

std::optional<double> percent_of(double a, double b) {
    if (a == 0)
        return std::nullopt;
    return (b - a) / a * 100;
}

}  // namespace dataflow::runs
