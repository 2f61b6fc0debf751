#include "dataflow/tools/sweeps/value_lists.hpp"

#include <fmt/format.h>
#include <set>

#include "dataflow/base/printable.hpp"
#include "dataflow/run/config/entry_faults.hpp"
#include "dataflow/run/config/plain_text.hpp"

namespace dataflow::sweeps {

void ValueLists::fault(int line, std::string const& key, std::string const& problem) const {
    cells_.faults().push_back({line, key, std::nullopt, problem});
}

void ValueLists::reject(MapEntry const& entry, std::string const& expected) const {
    dataflow::reject(cells_.faults(), entry, expected);
}

std::vector<Cell> ValueLists::cells_of(Key const& key, MapEntry const& list, bool distinct) const {
    std::vector<Cell> cells;
    if (!list.value.IsSequence() || list.value.size() == 0) {
        reject(list, "a list of values of " + key.name());
        return cells;
    }
    std::set<std::string> seen;
    for (YAML::Node const& value : list.value) {
        int const line = value.Mark().is_null() ? list.line : value.Mark().line + 1;
        auto const cell = cells_.cell(key, value, line);
        if (cell && !seen.insert(cell->text).second && distinct)
            fault(line, key.name(), shortened(cell->text) + " stands twice, expected each value once");
        if (cell)
            cells.push_back(*cell);
    }
    return cells;
}

std::optional<double> ValueLists::number(Key const& key, YAML::Node const& node, int line) const {
    auto const cell = cells_.cell(key, node, line);
    return cell ? parse_number(cell->text) : std::nullopt;
}

std::optional<std::pair<double, double>> ValueLists::bounds(Key const& key, MapEntry const& entry) const {
    if (key.kind != KeyKind::integer && key.kind != KeyKind::number) {
        fault(entry.line, key.name(), entry.name + " is for numbers, expected a list of values");
        return std::nullopt;
    }
    if (!entry.value.IsSequence() || entry.value.size() != 2) {
        reject(entry, "two numbers such as [2, 64]");
        return std::nullopt;
    }
    auto const low = number(key, entry.value[0], entry.line);
    auto const high = number(key, entry.value[1], entry.line);
    if (!low || !high)
        return std::nullopt;
    if (*low > *high) {
        fault(entry.line, entry.name, fmt::format("from {:g} down to {:g}, expected the smaller first", *low, *high));
        return std::nullopt;
    }
    return std::pair(*low, *high);
}

std::optional<std::int64_t> ValueLists::whole_number(MapEntry const& entry, std::int64_t least,
                                                     std::int64_t most) const {
    auto const value = entry.value.IsScalar() ? parse_integer(entry.value.Scalar()) : std::nullopt;
    if (value && *value >= least && *value <= most)
        return value;
    reject(entry, fmt::format("a whole number from {} to {}", least, most));
    return std::nullopt;
}

}  // namespace dataflow::sweeps
