#include "dataflow/tools/budgets/evaluate.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>

#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/tools/budgets/figure_pattern.hpp"

namespace dataflow::budgets {

namespace {

[[noreturn]] void fail(Budget const& budget, Limit const& limit, std::string const& problem) {
    throw InputError(fmt::format("{}:{}: limits.{}: {}", budget.file.string(), limit.line, limit.figure, problem));
}

/// What all limits together allow for a figure, and which of them say so.
class AllowedFigures {
  public:
    explicit AllowedFigures(Budget const& budget) : budget_(budget) {}

    void narrow(std::string const& figure, Interval const& interval, Limit const& limit) {
        Allowed& allowed = allowed_[figure];
        if (interval.lower && (!allowed.interval.lower || *interval.lower > *allowed.interval.lower)) {
            allowed.interval.lower = interval.lower;
            allowed.lower_line = limit.line;
        }
        if (interval.upper && (!allowed.interval.upper || *interval.upper < *allowed.interval.upper)) {
            allowed.interval.upper = interval.upper;
            allowed.upper_line = limit.line;
        }
        if (allowed.interval.lower && allowed.interval.upper && *allowed.interval.lower > *allowed.interval.upper)
            fail(budget_, limit,
                 fmt::format("contradictory limits: {} would have to be at least {:.0f} (line {}) and at most {:.0f} "
                             "(line {})",
                             figure, *allowed.interval.lower, allowed.lower_line, *allowed.interval.upper,
                             allowed.upper_line));
    }

  private:
    struct Allowed {
        Interval interval;
        int lower_line = 0;
        int upper_line = 0;
    };
    Budget const& budget_;
    std::map<std::string, Allowed> allowed_;
};

std::optional<double> percent_of(double margin, double bound) {
    return bound == 0 ? std::nullopt : std::optional(100 * margin / bound);
}

FigureCheck checked(Figure const& figure, Interval const& allowed) {
    auto const measured = static_cast<double>(figure.value);
    FigureCheck check{figure.name, figure.value, allowed, 0, std::nullopt};
    bool const upper_is_nearer =
        !allowed.lower || (allowed.upper && *allowed.upper - measured <= measured - *allowed.lower);
    double const bound = upper_is_nearer ? *allowed.upper : *allowed.lower;
    double const margin = upper_is_nearer ? bound - measured : measured - bound;
    check.margin = static_cast<std::int64_t>(margin);
    check.percent = percent_of(margin, bound);
    return check;
}

/// A sample or core that is gone must not pass unnoticed.
void require_all_of_baseline(Budget const& budget, Limit const& limit, FigurePattern const& pattern,
                             Figures const& figures, Figures const& baseline) {
    for (Figure const& figure : baseline.all())
        if (pattern.matches(figure.name) && !figures.find(figure.name))
            fail(budget, limit,
                 fmt::format("the baseline has {}, the run has not; expected the same figures "
                             "(--update --reason TEXT takes those of the run)",
                             figure.name));
}

Interval allowed_for(Figure const& figure, Budget const& budget, Limit const& limit, double clock_mhz,
                     Figures const& baseline) {
    Scale const scale{clock_mhz, baseline.find(figure.name)};
    if (limit.needs_baseline() && !scale.baseline)
        fail(budget, limit,
             fmt::format("no {} in the baseline, expected one; --update --reason TEXT writes it", figure.name));
    try {
        return interval_of(limit, scale);
    } catch (InputError const& error) {
        fail(budget, limit, error.what());
    }
}

Verdict judge(Budget const& budget, Limit const& limit, Measurement const& measurement, Figures const& baseline,
              AllowedFigures& all_limits) {
    FigurePattern const pattern(limit.figure);
    Verdict verdict{limit, {}, 0, {}};
    for (Figure const& figure : measurement.figures.all()) {
        if (!pattern.matches(figure.name))
            continue;
        Interval const allowed = allowed_for(figure, budget, limit, measurement.clock_mhz, baseline);
        all_limits.narrow(figure.name, allowed, limit);
        FigureCheck const check = checked(figure, allowed);
        if (verdict.matches++ == 0 || check.margin < verdict.tightest.margin)
            verdict.tightest = check;
        if (check.is_breached())
            verdict.breaches.push_back(check);
    }
    if (verdict.matches == 0)
        fail(budget, limit,
             fmt::format("matches no figure of the run, expected at least one; it has {} samples and {} {}",
                         measurement.figures.find("samples").value_or(0),
                         measurement.figures.find("raster_cores").value_or(0), cores_are()));
    if (limit.needs_baseline())
        require_all_of_baseline(budget, limit, pattern, measurement.figures, baseline);
    return verdict;
}

}  // namespace

std::vector<Verdict> evaluate(Budget const& budget, Measurement const& measurement, Baseline const& baseline) {
    AllowedFigures all_limits(budget);
    std::vector<Verdict> verdicts;
    for (Limit const& limit : budget.limits)
        verdicts.push_back(judge(budget, limit, measurement, baseline.figures, all_limits));
    return verdicts;
}

bool has_breach(std::vector<Verdict> const& verdicts) {
    return std::any_of(verdicts.begin(), verdicts.end(),
                       [](Verdict const& verdict) { return !verdict.breaches.empty(); });
}

}  // namespace dataflow::budgets
