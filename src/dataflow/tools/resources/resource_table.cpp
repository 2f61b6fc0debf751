#include "dataflow/tools/resources/resource_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "dataflow/tools/resources/fifo_cost.hpp"
#include "dataflow/tools/resources/unit_keys.hpp"

namespace dataflow {

namespace {

using Curve = std::map<double, Resources>;

std::optional<double> number(std::string const& text) {
    char* end = nullptr;
    double const value = std::strtod(text.c_str(), &end);
    return text.empty() || *end != '\0' ? std::nullopt : std::optional(value);
}

/// On the line through the two points next to `x`, or through the last two.
Resources on_line(Curve const& curve, double x) {
    if (curve.empty())
        throw std::out_of_range("no rows to interpolate between");
    auto right = curve.lower_bound(x);
    if (right != curve.end() && right->first == x)
        return right->second;
    if (curve.size() == 1)
        return curve.begin()->second;
    if (right == curve.begin())
        ++right;
    if (right == curve.end())
        --right;
    auto const left = std::prev(right);
    double const share = (x - left->first) / (right->first - left->first);
    return left->second + share * (right->second - left->second);
}

/// Whole primitives, and not fewer than none.
Resources whole(Resources const& a) {
    auto const up = [](double number) { return std::max(std::round(number), 0.0); };
    return {up(a.lut), up(a.ff), up(a.dsp), std::max(a.ramb36, 0.0)};
}

ResourceTable::Row row_of(std::string const& line) {
    std::vector<std::string> const texts = csv_cells(line);
    if (texts.size() != 6)
        throw std::invalid_argument("resource table: not six cells: " + line);
    std::vector<double> numbers;
    for (std::size_t i = 2; i < texts.size(); ++i) {
        std::optional<double> const value = number(texts[i]);
        if (!value)
            throw std::invalid_argument("resource table: no number: " + texts[i]);
        numbers.push_back(*value);
    }
    return {texts[0], unit_keys(texts[1]), {numbers[0], numbers[1], numbers[2], numbers[3]}};
}

}  // namespace

std::map<std::string, std::string> differing_keys(std::vector<UnitKey> const& keys) {
    std::map<std::string, std::string> differing;
    for (UnitKey const& key : keys)
        if (key.value != key.standard)
            differing[key.name] = key.value;
    return differing;
}

ResourceTable::ResourceTable(std::string_view csv) {
    std::istringstream lines{std::string(csv)};
    std::string line;
    if (!std::getline(lines, line) || line != "unit,configuration,lut,ff,dsp,ramb36")
        throw std::invalid_argument("resource table: not its columns: " + line);
    while (std::getline(lines, line))
        rows_.push_back(row_of(line));
}

ResourceTable::Row const* ResourceTable::row(std::string const& unit, Keys const& keys) const {
    auto const found =
        std::find_if(rows_.begin(), rows_.end(), [&](Row const& row) { return row.unit == unit && row.keys == keys; });
    return found == rows_.end() ? nullptr : &*found;
}

ResourceTable::Row const& ResourceTable::nearest(std::string const& unit, Keys const& keys) const {
    Row const* best = row(unit, {});
    if (best == nullptr)
        throw std::out_of_range("no synthesized unit " + unit);
    for (Row const& row : rows_)
        if (row.unit == unit && row.keys.size() > best->keys.size() &&
            std::includes(keys.begin(), keys.end(), row.keys.begin(), row.keys.end()))
            best = &row;
    return *best;
}

Resources ResourceTable::change(std::string const& unit, UnitKey const& key) const {
    Resources const standard = row(unit, {})->amount;
    if (Row const* alone = row(unit, {{key.name, key.value}}); alone != nullptr)
        return alone->amount - standard;
    std::optional<double> const value = number(key.value), at_standard = number(key.standard);
    if (!value || !at_standard)
        return {};
    Curve curve{{*at_standard, standard}};
    for (Row const& row : rows_)
        if (row.unit == unit && row.keys.size() == 1 && row.keys.count(key.name) > 0)
            curve[number(row.keys.at(key.name)).value()] = row.amount;
    return on_line(curve, *value) - standard;
}

ResourcePart ResourceTable::unit(std::string const& name, std::vector<UnitKey> const& keys) const {
    Keys const differing = differing_keys(keys);
    Row const& base = nearest(name, differing);
    if (base.keys == differing)
        return {name, base.amount, ResourceBasis::synthesized};
    Resources amount = base.amount;
    for (UnitKey const& key : keys)
        if (differing.count(key.name) > base.keys.count(key.name))
            amount += change(name, key);
    return {name, whole(amount), ResourceBasis::interpolated};
}

ResourcePart ResourceTable::on_grid(std::string const& name, std::string const& first, double at_first,
                                    std::string const& second, double at_second) const {
    std::map<double, Curve> curves;
    for (Row const& row : rows_)
        if (row.unit == name)
            curves[number(row.keys.at(first)).value()][number(row.keys.at(second)).value()] = row.amount;
    bool const is_row = curves.count(at_first) > 0 && curves.at(at_first).count(at_second) > 0;
    Curve along_first;
    for (auto const& [at, curve] : curves)
        along_first[at] = on_line(curve, at_second);
    return {name, whole(on_line(along_first, at_first)),
            is_row ? ResourceBasis::synthesized : ResourceBasis::interpolated};
}

double ResourceTable::largest(std::string const& unit, std::string const& key) const {
    double largest = 0;
    for (Row const& row : rows_)
        if (row.unit == unit)
            largest = std::max(largest, number(row.keys.at(key)).value());
    return largest;
}

ResourcePart ResourceTable::fifo(FifoKind kind, std::uint64_t tokens, unsigned bits) const {
    bool const is_memory = kind == FifoKind::memory;
    std::string const unit = is_memory ? "fifo.memory" : "fifo.shift_register";
    std::uint64_t places = is_memory ? 4 : tokens;
    while (places < tokens)
        places *= 2;
    std::uint64_t const in_rows = std::min(places, static_cast<std::uint64_t>(largest(unit, "depth")));
    ResourcePart part = on_grid(unit, "depth", static_cast<double>(in_rows), "bits", bits);
    if (places != tokens)
        part.basis = ResourceBasis::interpolated;
    if (places > in_rows) {
        part.amount += counted_fifo(kind, places, places, bits) - counted_fifo(kind, in_rows, in_rows, bits);
        part.basis = ResourceBasis::counted;
    }
    part.amount.ramb36 = std::ceil(2 * part.amount.ramb36) / 2;  // whole RAMB18
    return part;
}

}  // namespace dataflow
