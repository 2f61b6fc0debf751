#include "kernel/budgets/check_json.hpp"

#include "kernel/base/files/json_file.hpp"
#include "kernel/base/json.hpp"

namespace faster::budgets {

namespace {

template <class Value> Json or_null(std::optional<Value> const& value) { return value ? Json(*value) : Json(nullptr); }

Json whole_or_null(std::optional<double> const& bound) {
    return bound ? Json(static_cast<std::int64_t>(*bound)) : Json(nullptr);
}

Json comparison_row(Comparison const& comparison) {
    return {{"figure", comparison.figure},
            {"measured", comparison.measured},
            {"at_least", whole_or_null(comparison.allowed.lower)},
            {"at_most", whole_or_null(comparison.allowed.upper)},
            {"margin", comparison.margin},
            {"percent", or_null(comparison.percent)}};
}

Json limit_row(Verdict const& verdict) {
    Json breaches = Json::array();
    for (Comparison const& breach : verdict.breaches)
        breaches.push_back(comparison_row(breach));
    return {{"figure", verdict.limit.figure},
            {"line", verdict.limit.line},
            {"limit", verdict.limit.text()},
            {"matches", verdict.matches},
            {"passed", verdict.breaches.empty()},
            {"tightest", comparison_row(verdict.tightest)},
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
            {"status", name_of(result.status)},
            {"message", result.message},
            {"limits", limits},
            {"baseline", baseline},
            {"moved", moved(result.explanation)},
            {"host_seconds", result.seconds}};
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

}  // namespace faster::budgets
