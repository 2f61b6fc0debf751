#include "dataflow/tools/budgets/budget.hpp"

#include <cmath>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"

namespace dataflow::budgets {

namespace {

bool is_baseline(std::optional<Quantity> const& quantity) {
    return quantity && quantity->kind == Quantity::Kind::baseline;
}

/// A time is a decimal fraction, so cycles come out whole only up to rounding.
double snapped(double cycles) {
    constexpr double tolerance = 1e-9;
    double const whole = std::round(cycles);
    return std::abs(cycles - whole) <= tolerance * std::max(1.0, whole) ? whole : cycles;
}

double value_of(Quantity const& quantity, Scale const& scale) {
    switch (quantity.kind) {
        case Quantity::Kind::count:
            break;
        case Quantity::Kind::microseconds:
            return snapped(quantity.value * scale.clock_mhz);
        case Quantity::Kind::baseline:
            return static_cast<double>(scale.baseline.value());
    }
    return quantity.value;
}

double whole_value_of(Quantity const& exact, Scale const& scale) {
    double const value = value_of(exact, scale);
    if (value != std::floor(value))
        throw InputError(
            fmt::format("exact = {}, expected a whole number of cycles at {:g} MHz ({:.0f} cycles are {} us)",
                        exact.text, scale.clock_mhz, value, std::round(value) / scale.clock_mhz));
    return value;
}

}  // namespace

bool Limit::needs_baseline() const {
    return is_baseline(min) || is_baseline(max) || is_baseline(exact) || is_baseline(of);
}

std::string Limit::text() const {
    if (exact)
        return "exact " + exact->text;
    if (of)
        return fmt::format("within {:g} % of {}", percent, of->text);
    std::string text = min ? "min " + min->text : "";
    if (max)
        text += (text.empty() ? "" : ", ") + std::string("max ") + max->text;
    if (slack > 0)
        text += fmt::format(", {:g} % slack", slack);
    return text;
}

Interval interval_of(Limit const& limit, Scale const& scale) {
    if (limit.exact) {
        double const value = whole_value_of(*limit.exact, scale);
        return {value, value};
    }
    Interval interval;
    if (limit.min)
        interval.lower = std::ceil(snapped(value_of(*limit.min, scale) * (1 - limit.slack / 100)));
    if (limit.max)
        interval.upper = std::floor(snapped(value_of(*limit.max, scale) * (1 + limit.slack / 100)));
    if (limit.of) {
        double const centre = value_of(*limit.of, scale);
        double const spread = centre * limit.percent / 100;
        interval = {std::ceil(snapped(centre - spread)), std::floor(snapped(centre + spread))};
    }
    return interval;
}

}  // namespace dataflow::budgets
