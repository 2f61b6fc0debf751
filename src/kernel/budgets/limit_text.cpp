#include "kernel/budgets/limit_text.hpp"

#include <cstdlib>
#include <fmt/format.h>

#include "kernel/budgets/figure_facts.hpp"

namespace faster::budgets {

namespace {

bool is_plain_count(std::optional<Quantity> const& quantity) {
    return !quantity || quantity->kind == Quantity::Kind::count;
}

std::string interval_text(Interval const& interval) {
    if (interval.lower && interval.upper && *interval.lower != *interval.upper)
        return fmt::format("{:.0f}..{:.0f}", *interval.lower, *interval.upper);
    return fmt::format("{:.0f}", interval.upper ? *interval.upper : *interval.lower);
}

}  // namespace

std::string limit_text(Limit const& limit, Interval const& allowed) {
    bool const says_all =
        is_plain_count(limit.min) && is_plain_count(limit.max) && is_plain_count(limit.exact) && !limit.of;
    return says_all ? limit.text() : limit.text() + " = " + interval_text(allowed);
}

std::string breach_text(Limit const& limit, Comparison const& breach) {
    bool const above = breach.allowed.upper && static_cast<double>(breach.measured) > *breach.allowed.upper;
    return fmt::format("{} = {}, expected {}: {}{} {}", breach.figure, breach.measured,
                       limit_text(limit, breach.allowed), std::abs(breach.margin),
                       is_in_cycles(breach.figure) ? (breach.margin == -1 ? " cycle" : " cycles") : "",
                       above ? "above" : "below");
}

}  // namespace faster::budgets
