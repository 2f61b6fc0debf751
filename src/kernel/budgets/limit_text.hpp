#pragma once
#include <string>

#include "kernel/budgets/evaluate.hpp"

namespace faster::budgets {

/// A limit for people, e.g. "max 1.5 ms = 300000": in the budget's words, and in cycles where these are others.
std::string limit_text(Limit const& limit, Interval const& allowed);

/// One sentence on a breach: "samples.3.latency_cycles = 5112, expected exact baseline = 5110: 2 cycles above".
std::string breach_text(Limit const& limit, Comparison const& breach);

}  // namespace faster::budgets
