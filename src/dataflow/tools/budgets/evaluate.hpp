#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/tools/budgets/budget.hpp"
#include "dataflow/tools/budgets/measurement.hpp"

namespace dataflow::budgets {

/// One figure against its limit.
struct FigureCheck {
    std::string figure;
    std::uint64_t measured = 0;
    Interval allowed;
    std::int64_t margin = 0;        ///< how far the figure may still move; negative: by how much it is outside
    std::optional<double> percent;  ///< margin in per cent of the bound it is measured from; nothing if that is 0

    bool is_breached() const { return margin < 0; }
};

/// One limit against all figures that it matches, at least one.
struct Verdict {
    Limit limit;
    FigureCheck tightest;  ///< of those with the smallest margin, the first
    std::size_t matches = 0;
    std::vector<FigureCheck> breaches;
};

/// Compares a finished run with a budget's limits, in the order of the file. `baseline` is what limits refer to. Throws
/// InputError that names file and line for a limit that matches no figure, or other figures than the baseline has, and
/// for limits that contradict each other.
std::vector<Verdict> evaluate(Budget const& budget, Measurement const& measurement, Baseline const& baseline);

bool has_breach(std::vector<Verdict> const& verdicts);

}  // namespace dataflow::budgets
