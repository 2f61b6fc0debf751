#include "kernel/budgets/explain.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>

#include "kernel/config/design.hpp"
#include "kernel/config/keys.hpp"
#include "kernel/config/plain_value.hpp"

namespace faster::budgets {

namespace {

enum class Group { shape, work, waiting, result, none };

constexpr std::array<std::string_view, 5> work_of_modules{"busy_cycles", "fill_drain_cycles", "setup_cycles",
                                                          "port_conflict_cycles", "recurrence_cycles"};
constexpr std::array<std::string_view, 3> waiting_of_fifos{"full_stall_cycles", "empty_stall_cycles", "max_occupancy"};

template <class Words> bool is_one_of(std::string const& word, Words const& words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

Group group_of(std::vector<std::string> const& parts) {
    std::string const& table = parts.front();
    std::string const& figure = parts.back();
    if (table == "samples" && parts.size() > 1)
        return is_one_of(figure, design().counters()) ? Group::result : Group::none;
    if (table == "cores" || table == "total_cycles")
        return Group::none;
    if (table == "modules")
        return is_one_of(figure, work_of_modules) ? Group::work : Group::waiting;
    if (table == "fifos" && is_one_of(figure, waiting_of_fifos))
        return Group::waiting;
    return is_largest_over_cores(figure) || parts.size() == 1 ? Group::shape : Group::work;
}

bool is_larger(runs::Change const& left, runs::Change const& right) {
    return std::abs(left.difference()) > std::abs(right.difference());
}

runs::Change change_of(Figure const& before, std::vector<std::string> const& parts,
                       std::optional<std::uint64_t> after) {
    std::size_t const item_length = before.name.size() - parts.back().size();
    return {before.name.substr(0, item_length == 0 ? 0 : item_length - 1), parts.back(), before.value, after};
}

std::optional<std::string> value_of(std::vector<Setting> const& settings, std::string const& key) {
    auto const found =
        std::find_if(settings.begin(), settings.end(), [&key](Setting const& setting) { return setting.key == key; });
    return found == settings.end() ? std::nullopt : std::optional(found->value);
}

std::string default_of(std::string const& key) {
    Key const* const found = find_key(key);
    if (found == nullptr)
        return "-";
    return plain_text(found->read(RunConfig{}));
}

std::vector<runs::SettingChange> setting_changes(std::vector<Setting> const& a, std::vector<Setting> const& b) {
    std::vector<std::string> keys;
    for (auto const* const settings : {&a, &b})
        for (Setting const& setting : *settings)
            if (std::find(keys.begin(), keys.end(), setting.key) == keys.end())
                keys.push_back(setting.key);
    std::vector<runs::SettingChange> changes;
    for (std::string const& key : keys) {
        std::string const before = value_of(a, key).value_or(default_of(key));
        std::string const after = value_of(b, key).value_or(default_of(key));
        if (before != after)
            changes.push_back({key, before, after});
    }
    return changes;
}

}  // namespace

Explanation explain(Baseline const& baseline, Measurement const& measurement) {
    Explanation explanation;
    explanation.same_configuration = baseline.configuration == measurement.configuration;
    explanation.settings = setting_changes(baseline.accelerator, measurement.accelerator);
    if (measurement.kind != Measurement::Kind::figures)
        return explanation;
    std::array<std::vector<runs::Change>, 5> groups;
    for (Figure const& before : baseline.figures.all()) {
        std::vector<std::string> const parts = parts_of(before.name);
        runs::Change const change = change_of(before, parts, measurement.figures.find(before.name));
        if (change.difference() != 0)
            groups[static_cast<std::size_t>(group_of(parts))].push_back(change);
    }
    for (auto& group : groups)
        std::stable_sort(group.begin(), group.end(), is_larger);
    explanation.shapes = groups[static_cast<std::size_t>(Group::shape)];
    explanation.work = groups[static_cast<std::size_t>(Group::work)];
    explanation.waiting = groups[static_cast<std::size_t>(Group::waiting)];
    explanation.results = groups[static_cast<std::size_t>(Group::result)];
    return explanation;
}

}  // namespace faster::budgets
