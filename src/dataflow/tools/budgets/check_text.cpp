#include "dataflow/tools/budgets/check_text.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fmt/format.h>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/base/text_lines.hpp"
#include "dataflow/tools/budgets/figures.hpp"

namespace dataflow::budgets {

namespace {

bool is_plain_count(std::optional<Quantity> const& quantity) {
    return !quantity || quantity->kind == Quantity::Kind::count;
}

std::string bound_text(double bound) { return grouped_digits(fmt::format("{:.0f}", bound)); }

std::string interval_text(Interval const& interval) {
    if (interval.lower && interval.upper && *interval.lower != *interval.upper)
        return bound_text(*interval.lower) + ".." + bound_text(*interval.upper);
    return bound_text(interval.upper ? *interval.upper : *interval.lower);
}

constexpr std::size_t most_breaches = 5;

using Row = std::array<std::string, 6>;

Row row_of(Verdict const& verdict) {
    FigureCheck const& tightest = verdict.tightest;
    std::string place = verdict.matches > 1 ? tightest.figure : "";
    if (verdict.matches > 1)
        place += verdict.breaches.empty() ? fmt::format(" of {}", verdict.matches)
                                          : fmt::format(", {} of {} broken", verdict.breaches.size(), verdict.matches);
    return {(verdict.breaches.empty() ? "  " : "! ") + verdict.limit.figure,
            limit_text(verdict.limit, tightest.allowed),
            grouped(tightest.measured),
            grouped_change(tightest.margin),
            tightest.percent ? fmt::format("{:+.2f} %", *tightest.percent) : "-",
            place};
}

/// Names to the left, figures to the right. The last column is as wide as it is.
void table(std::string& text, std::vector<Verdict> const& verdicts) {
    std::vector<Row> rows{{"  figure", "limit", "measured", "margin", "percent", "at the tightest"}};
    for (Verdict const& verdict : verdicts)
        rows.push_back(row_of(verdict));
    auto const widths = widths_of(rows);
    for (Row const& row : rows) {
        std::string cells = fmt::format("{:<{}}  {:<{}}  {:>{}}  {:>{}}  {:>{}}  {}", row[0], widths[0], row[1],
                                        widths[1], row[2], widths[2], row[3], widths[3], row[4], widths[4], row[5]);
        cells.erase(cells.find_last_not_of(' ') + 1);
        put_line(text, "{}", cells);
    }
}

void breaches(std::string& text, std::vector<Verdict> const& verdicts) {
    for (Verdict const& verdict : verdicts) {
        std::size_t const shown = std::min(most_breaches, verdict.breaches.size());
        for (std::size_t i = 0; i < shown; ++i)
            put_line(text, "  broken: {}", breach_text(verdict.limit, verdict.breaches[i]));
        if (shown < verdict.breaches.size())
            put_line(text, "  ... and {} more of {}", verdict.breaches.size() - shown, verdict.limit.figure);
    }
}

std::string figure_name(runs::Change const& change) {
    return change.item.empty() ? change.figure : change.item + "." + change.figure;
}

void changes(std::string& text, char const* title, std::vector<runs::Change> const& list, std::size_t top) {
    std::size_t const shown = std::min(top, list.size());
    for (std::size_t i = 0; i < shown; ++i) {
        runs::Change const& change = list[i];
        auto const percent = change.percent();
        put_line(text, "    {:<8} {}  {} -> {}  {}{}", i == 0 ? title : "", figure_name(change), grouped(change.a),
                 grouped(change.b), grouped_change(change.difference()),
                 percent ? fmt::format(" ({:+.2f} %)", *percent) : "");
    }
    if (shown < list.size())
        put_line(text, "    {:<8} ... and {} more", "", list.size() - shown);
}

void since_baseline(std::string& text, CheckResult const& result) {
    if (result.baseline_date.empty())
        return;
    put_line(text, "  what moved since the baseline of {} (\"{}\"):", result.baseline_date, result.baseline_reason);
    if (result.explanation.is_empty() && result.status == CheckResult::Status::breached)
        put_line(text, "    nothing: the baseline does not keep this limit either");
    text += explanation_text(result.explanation, most_breaches);
}

std::string indented(std::string const& message) {
    std::string text = "  " + with_replaced(message, {{'\n', "\n  "}});
    text.erase(text.find_last_not_of(" \n") + 1);
    return text + "\n";
}

}  // namespace

std::string limit_text(Limit const& limit, Interval const& allowed) {
    bool const says_all =
        is_plain_count(limit.min) && is_plain_count(limit.max) && is_plain_count(limit.exact) && !limit.of;
    return says_all ? limit.text() : limit.text() + " = " + interval_text(allowed);
}

std::string breach_text(Limit const& limit, FigureCheck const& breach) {
    bool const above = breach.allowed.upper && static_cast<double>(breach.measured) > *breach.allowed.upper;
    return fmt::format("{} = {}, expected {}: {}{} {}", breach.figure, grouped(breach.measured),
                       limit_text(limit, breach.allowed), grouped(static_cast<std::uint64_t>(std::abs(breach.margin))),
                       is_in_cycles(breach.figure) ? (breach.margin == -1 ? " cycle" : " cycles") : "",
                       above ? "above" : "below");
}

std::string explanation_text(Explanation const& explanation, std::size_t top) {
    std::string text;
    for (runs::SettingChange const& setting : explanation.settings)
        put_line(text, "    {:<8} {}  {} -> {}", "setting", setting.key, setting.a.value_or("-"),
                 setting.b.value_or("-"));
    if (!explanation.same_configuration && explanation.settings.empty())
        put_line(text, "    {:<8} other keys than those of the accelerator", "setting");
    changes(text, "shape", explanation.shapes, top);
    changes(text, "work", explanation.work, top);
    changes(text, "waiting", explanation.waiting, top);
    changes(text, "result", explanation.results, top);
    return text;
}

std::string check_text(CheckResult const& result) {
    std::string text;
    put_line(text, "{}: {}", result.file, result.is_failure() ? enumerator_name(result.status) : "passed");
    if (!result.updated.empty())
        put_line(text, "  {}", result.updated);
    if (!result.verdicts.empty())
        table(text, result.verdicts);
    breaches(text, result.verdicts);
    if (!result.message.empty())
        text += indented(result.message);
    if (result.status == CheckResult::Status::breached || result.status == CheckResult::Status::deadlocked)
        since_baseline(text, result);
    return text;
}

std::string totals_text(std::vector<CheckResult> const& results) {
    using Status = CheckResult::Status;
    std::string text = fmt::format("{} budget{}:", results.size(), results.size() == 1 ? "" : "s");
    std::string separator = " ";
    for (Status const status :
         {Status::passed, Status::breached, Status::deadlocked, Status::timed_out, Status::crashed, Status::bad}) {
        auto const count = std::count_if(results.begin(), results.end(),
                                         [status](CheckResult const& result) { return result.status == status; });
        if (count > 0)
            text += fmt::format("{}{} {}", separator, count, enumerator_name(status));
        separator = count > 0 ? ", " : separator;
    }
    return text + "\n";
}

}  // namespace dataflow::budgets
