#include "dataflow/tools/budgets/check_files.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/base/markup_text.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/tools/budgets/check_text.hpp"

namespace dataflow::budgets {

namespace {

Json whole_or_null(std::optional<double> const& bound) {
    return bound ? Json(static_cast<std::int64_t>(*bound)) : Json(nullptr);
}

Json check_row(FigureCheck const& check) {
    return {{"figure", check.figure},
            {"measured", check.measured},
            {"at_least", whole_or_null(check.allowed.lower)},
            {"at_most", whole_or_null(check.allowed.upper)},
            {"margin", check.margin},
            {"percent", or_null(check.percent)}};
}

Json limit_row(Verdict const& verdict) {
    Json breaches = Json::array();
    for (FigureCheck const& breach : verdict.breaches)
        breaches.push_back(check_row(breach));
    return {{"figure", verdict.limit.figure},
            {"line", verdict.limit.line},
            {"limit", verdict.limit.text()},
            {"matches", verdict.matches},
            {"passed", verdict.breaches.empty()},
            {"tightest", check_row(verdict.tightest)},
            {"breaches", breaches}};
}

Json change_rows(std::vector<runs::Change> const& changes) {
    Json rows = Json::array();
    for (runs::Change const& change : changes)
        rows.push_back({{"item", change.item},
                        {"figure", change.figure},
                        {"baseline", or_null(change.a)},
                        {"measured", or_null(change.b)},
                        {"difference", change.difference()}});
    return rows;
}

Json moved(Explanation const& explanation) {
    Json settings = Json::array();
    for (runs::SettingChange const& setting : explanation.settings)
        settings.push_back({{"key", setting.key}, {"baseline", or_null(setting.a)}, {"measured", or_null(setting.b)}});
    return {{"same_configuration", explanation.same_configuration},
            {"settings", settings},
            {"shapes", change_rows(explanation.shapes)},
            {"work", change_rows(explanation.work)},
            {"waiting", change_rows(explanation.waiting)},
            {"results", change_rows(explanation.results)}};
}

Json budget_row(CheckResult const& result) {
    Json limits = Json::array();
    for (Verdict const& verdict : result.verdicts)
        limits.push_back(limit_row(verdict));
    Json const baseline = result.baseline_date.empty()
                              ? Json(nullptr)
                              : Json{{"date", result.baseline_date}, {"reason", result.baseline_reason}};
    return {{"name", result.name},
            {"file", result.file},
            {"status", enumerator_name(result.status)},
            {"message", result.message},
            {"limits", limits},
            {"baseline", baseline},
            {"moved", moved(result.explanation)},
            {"host_seconds", result.seconds}};
}

constexpr std::size_t contributors = 10;

std::string since_baseline(CheckResult const& result) {
    if (result.baseline_date.empty())
        return "";
    return fmt::format("what moved since the baseline of {} (\"{}\"):\n{}", result.baseline_date,
                       result.baseline_reason, explanation_text(result.explanation, contributors));
}

std::string failed_limit(CheckResult const& result, Verdict const& verdict) {
    std::string text;
    for (FigureCheck const& breach : verdict.breaches)
        text += breach_text(verdict.limit, breach) + "\n";
    return fmt::format("      <failure type=\"breach\" message=\"{}\">{}</failure>\n",
                       xml_text(breach_text(verdict.limit, verdict.tightest)), xml_text(text + since_baseline(result)));
}

using Texts = std::vector<std::string>;

bool are_unique(Texts const& texts) { return std::set<std::string>(texts.begin(), texts.end()).size() == texts.size(); }

/// CI services keep one of several test cases of one class and name. The name of a budget is that of its file; where
/// several have it, the file's path as it was given.
Texts class_names(std::vector<CheckResult> const& results) {
    std::map<std::string, Texts> files_of_name;
    for (CheckResult const& result : results)
        files_of_name[result.name].push_back(
            std::filesystem::path(result.file).lexically_normal().replace_extension().string());
    Texts names;
    for (CheckResult const& result : results) {
        Texts const& files = files_of_name[result.name];
        std::filesystem::path path = std::filesystem::path(result.file).lexically_normal();
        if (are_unique(files))
            path.replace_extension();
        names.push_back(files.size() == 1 ? result.name : path.string());
    }
    return names;
}

std::string case_name(Verdict const& verdict) { return verdict.limit.figure + ": " + verdict.limit.text(); }

/// A figure may have two limits that read alike, as total_cycles and as milliseconds.
std::string unique_case_name(Verdict const& verdict, CheckResult const& result) {
    auto const reads_alike = [&](Verdict const& other) { return case_name(other) == case_name(verdict); };
    bool const is_unique = std::count_if(result.verdicts.begin(), result.verdicts.end(), reads_alike) == 1;
    return is_unique ? case_name(verdict) : fmt::format("{} (line {})", case_name(verdict), verdict.limit.line);
}

std::string limit_case(CheckResult const& result, std::string const& name, Verdict const& verdict) {
    std::string const head = fmt::format("    <testcase classname=\"{}\" name=\"{}\" time=\"0\"", xml_text(name),
                                         xml_text(unique_case_name(verdict, result)));
    if (verdict.breaches.empty())
        return head + "/>\n";
    return head + ">\n" + failed_limit(result, verdict) + "    </testcase>\n";
}

/// Of a run that has no figures.
std::string simulation_case(CheckResult const& result, std::string const& name) {
    bool const deadlocked = result.status == CheckResult::Status::deadlocked;
    std::string const tag = deadlocked ? "failure" : "error";
    std::string const text = deadlocked ? result.message + since_baseline(result) : result.message;
    return fmt::format(
        "    <testcase classname=\"{}\" name=\"simulation\" time=\"{:.3f}\">\n"
        "      <{} type=\"{}\" message=\"{}\">{}</{}>\n    </testcase>\n",
        xml_text(name), result.seconds, tag, enumerator_name(result.status),
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

std::string suite(CheckResult const& result, std::string const& name) {
    std::string text = fmt::format("  <testsuite name=\"{}\" file=\"{}\" {}>\n", xml_text(name), xml_text(result.file),
                                   attributes(counts_of(result), result.seconds));
    for (Verdict const& verdict : result.verdicts)
        text += limit_case(result, name, verdict);
    if (result.verdicts.empty())
        text += simulation_case(result, name);
    return text + "  </testsuite>\n";
}

}  // namespace

std::string check_json(std::vector<CheckResult> const& results) {
    Json json{{"format", "faster-check"}, {"version", 1}, {"passed", true}, {"budgets", Json::array()}};
    for (CheckResult const& result : results) {
        json["budgets"].push_back(budget_row(result));
        json["passed"] = json["passed"].get<bool>() && !result.is_failure();
    }
    return io::text_of(json, 2) + "\n";
}

/// XML has no control characters but tab and line end, not even escaped.
std::string xml_text(std::string const& text) { return markup_escaped(printable_lines(text)); }

std::string junit_xml(std::vector<CheckResult> const& results) {
    Counts all;
    double seconds = 0;
    std::string suites;
    Texts const names = class_names(results);
    for (std::size_t i = 0; i < results.size(); ++i) {
        CheckResult const& result = results[i];
        Counts const counts = counts_of(result);
        all = {all.tests + counts.tests, all.failures + counts.failures, all.errors + counts.errors};
        seconds += result.seconds;
        suites += suite(result, names[i]);
    }
    return fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"{} check\" {}>\n{}"
        "</testsuites>\n",
        xml_text(program_name()), attributes(all, seconds), suites);
}

}  // namespace dataflow::budgets
