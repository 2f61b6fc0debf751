#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace dataflow {

/// What a field of an item holds.
using ItemPart = std::variant<std::string, std::array<double, 3>>;

/// One item of a list: its fields by name, in the order of Key::fields.
struct ItemValue {
    std::vector<std::pair<std::string, ItemPart>> fields;
};

/// The value of one configuration key, in the types JSON has. Choices and paths are text; three numbers and a list of
/// items are the only compound values.
using KeyValue = std::variant<bool, std::int64_t, double, std::string, std::array<double, 3>, std::vector<ItemValue>>;

/// The value as JSON on one line, which is YAML as well. Numbers have just the digits that bring back the same value,
/// so two values are equal exactly if their texts are.
std::string json_text(KeyValue const& value);

}  // namespace dataflow
