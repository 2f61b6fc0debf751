#include "dataflow/tools/budgets/check_result.hpp"

#include <utility>

#include "dataflow/base/text_lines.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/tools/budgets/figures.hpp"
#include "dataflow/tools/compare/compare.hpp"

namespace dataflow::budgets {

namespace {

/// Work does not depend on time, nor do results; what tells when something was done follows from all of them.
std::vector<runs::Change>* list_for(Explanation& explanation, std::string const& figure) {
    if (split_at_points(figure).front() == "cores")
        return nullptr;
    switch (facts_of(figure).tells) {
        case Tells::shape:
            return &explanation.shapes;
        case Tells::work:
            return &explanation.work;
        case Tells::waiting:
        case Tells::peak:
            return &explanation.waiting;
        case Tells::result:
            return &explanation.results;
        case Tells::key:
        case Tells::when:
            break;
    }
    return nullptr;
}

runs::Change change_of(Figure const& before, std::optional<std::uint64_t> after) {
    std::size_t const point = before.name.rfind('.');
    if (point == std::string::npos)
        return {"", before.name, before.value, after};
    return {before.name.substr(0, point), before.name.substr(point + 1), before.value, after};
}

std::string default_of(std::string const& key) {
    Key const* const found = find_key(key);
    if (found == nullptr)
        return "-";
    return plain_text(found->read(RunConfig{}));
}

/// A key that one of them does not have is at its default there.
std::vector<runs::SettingChange> setting_changes(std::vector<Setting> const& a, std::vector<Setting> const& b) {
    std::vector<runs::SettingChange> rows = runs::joined(a, b);
    for (runs::SettingChange& row : rows)
        for (std::optional<std::string>* const value : {&row.a, &row.b})
            if (!*value)
                *value = default_of(row.key);
    return runs::changed(std::move(rows));
}

}  // namespace

Explanation explain(Baseline const& baseline, Measurement const& measurement) {
    Explanation explanation;
    explanation.same_configuration = baseline.configuration == measurement.configuration;
    explanation.settings = setting_changes(baseline.accelerator, measurement.accelerator);
    if (measurement.kind != Measurement::Kind::figures)
        return explanation;
    for (Figure const& before : baseline.figures.all()) {
        runs::Change const change = change_of(before, measurement.figures.find(before.name));
        if (auto* const list = list_for(explanation, before.name); list != nullptr && change.difference() != 0)
            list->push_back(change);
    }
    for (auto* const list : {&explanation.shapes, &explanation.work, &explanation.waiting, &explanation.results})
        runs::sort_by_difference(*list);
    return explanation;
}

}  // namespace dataflow::budgets
