#include "kernel/compare/comparison.hpp"

namespace faster::runs {

std::int64_t Change::difference() const {
    return static_cast<std::int64_t>(b.value_or(0)) - static_cast<std::int64_t>(a.value_or(0));
}

std::optional<double> percent_of(double a, double b) {
    if (a == 0)
        return std::nullopt;
    return (b - a) / a * 100;
}

}  // namespace faster::runs
