#include "kernel/compare/setting_changes.hpp"

#include <algorithm>
#include <map>

namespace faster::runs {

namespace {

using Settings = std::vector<ConfigurationEntry>;

std::map<std::string, std::string> by_key(Settings const& settings) {
    std::map<std::string, std::string> values;
    for (auto const& [key, value] : settings)
        values[key] = value;
    return values;
}

}  // namespace

std::vector<SettingChange> joined(Settings const& a, Settings const& b) {
    auto const in_a = by_key(a);
    auto const in_b = by_key(b);
    std::vector<SettingChange> rows;
    for (auto const& [key, value] : a) {
        auto const other = in_b.find(key);
        rows.push_back({key, value, other == in_b.end() ? std::nullopt : std::optional(other->second)});
    }
    for (auto const& [key, value] : b)
        if (in_a.count(key) == 0)
            rows.push_back({key, std::nullopt, value});
    return rows;
}

std::vector<SettingChange> changed(std::vector<SettingChange> rows) {
    auto const is_same = [](SettingChange const& row) { return row.a == row.b; };
    rows.erase(std::remove_if(rows.begin(), rows.end(), is_same), rows.end());
    return rows;
}

}  // namespace faster::runs
