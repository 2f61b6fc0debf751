#include "kernel/budgets/junit_xml.hpp"

#include <fmt/format.h>

#include "kernel/base/markup_text.hpp"
#include "kernel/base/printable.hpp"
#include "kernel/budgets/check_text.hpp"
#include "kernel/budgets/limit_text.hpp"

namespace faster::budgets {

namespace {

constexpr std::size_t contributors = 10;

std::string since_baseline(CheckResult const& result) {
    if (result.baseline_date.empty())
        return "";
    return fmt::format("what moved since the baseline of {} (\"{}\"):\n{}", result.baseline_date,
                       result.baseline_reason, explanation_text(result.explanation, contributors));
}

std::string failed_limit(CheckResult const& result, Verdict const& verdict) {
    std::string text;
    for (Comparison const& breach : verdict.breaches)
        text += breach_text(verdict.limit, breach) + "\n";
    return fmt::format("      <failure type=\"breach\" message=\"{}\">{}</failure>\n",
                       xml_text(breach_text(verdict.limit, verdict.tightest)), xml_text(text + since_baseline(result)));
}

std::string limit_case(CheckResult const& result, Verdict const& verdict) {
    std::string const head =
        fmt::format("    <testcase classname=\"{}\" name=\"{}: {}\" time=\"0\"", xml_text(result.name),
                    xml_text(verdict.limit.figure), xml_text(verdict.limit.text()));
    if (verdict.breaches.empty())
        return head + "/>\n";
    return head + ">\n" + failed_limit(result, verdict) + "    </testcase>\n";
}

/// Of a run that has no figures.
std::string simulation_case(CheckResult const& result) {
    bool const deadlocked = result.status == CheckResult::Status::deadlocked;
    std::string const tag = deadlocked ? "failure" : "error";
    std::string const text = deadlocked ? result.message + since_baseline(result) : result.message;
    return fmt::format(
        "    <testcase classname=\"{}\" name=\"simulation\" time=\"{:.3f}\">\n"
        "      <{} type=\"{}\" message=\"{}\">{}</{}>\n    </testcase>\n",
        xml_text(result.name), result.seconds, tag, name_of(result.status),
        xml_text(result.message.substr(0, result.message.find('\n'))), xml_text(text), tag);
}

struct Counts {
    std::size_t tests = 0;
    std::size_t failures = 0;
    std::size_t errors = 0;
};

Counts counts_of(CheckResult const& result) {
    Counts counts{result.verdicts.size(), 0, 0};
    for (Verdict const& verdict : result.verdicts)
        counts.failures += verdict.breaches.empty() ? 0U : 1U;
    if (result.verdicts.empty()) {
        counts.tests = 1;
        counts.failures = result.status == CheckResult::Status::deadlocked ? 1 : 0;
        counts.errors = 1 - counts.failures;
    }
    return counts;
}

std::string attributes(Counts const& counts, double seconds) {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"{}\" time=\"{:.3f}\"", counts.tests, counts.failures,
                       counts.errors, seconds);
}

std::string suite(CheckResult const& result) {
    std::string text = fmt::format("  <testsuite name=\"{}\" file=\"{}\" {}>\n", xml_text(result.name),
                                   xml_text(result.file), attributes(counts_of(result), result.seconds));
    for (Verdict const& verdict : result.verdicts)
        text += limit_case(result, verdict);
    if (result.verdicts.empty())
        text += simulation_case(result);
    return text + "  </testsuite>\n";
}

}  // namespace

/// XML has no control characters but tab and line end, not even escaped.
std::string xml_text(std::string const& text) { return markup_escaped(printable_lines(text)); }

std::string junit_xml(std::vector<CheckResult> const& results) {
    Counts all;
    double seconds = 0;
    std::string suites;
    for (CheckResult const& result : results) {
        Counts const counts = counts_of(result);
        all = {all.tests + counts.tests, all.failures + counts.failures, all.errors + counts.errors};
        seconds += result.seconds;
        suites += suite(result);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"faster-sim check\" {}>\n{}"
        "</testsuites>\n",
        attributes(all, seconds), suites);
}

}  // namespace faster::budgets
