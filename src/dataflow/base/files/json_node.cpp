#include "dataflow/base/files/json_node.hpp"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"

namespace dataflow::io {
namespace {

std::vector<std::string> keys_of(Json const& object) {
    std::vector<std::string> keys;
    for (auto const& member : object.items())
        keys.push_back(member.key());
    return keys;
}

std::optional<int> integer_of(std::string const& text) {
    int value = 0;
    char const* const end = text.data() + text.size();
    auto const result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc{} && result.ptr == end && value >= 0 ? std::optional(value) : std::nullopt;
}

}  // namespace

JsonNode::JsonNode(File file, std::string name, Json const& value)
    : file_(std::move(file)), name_(std::move(name)), value_(&value) {}

JsonNode JsonNode::member(std::string const& key, Json const& value) const {
    return {file_, name_.empty() ? key : name_ + "." + key, value};
}

void JsonNode::require_object() const {
    if (!value_->is_object())
        fail("an object");
}

std::optional<JsonNode> JsonNode::find(std::string const& key) const {
    require_object();
    auto const found = value_->find(key);
    return found == value_->end() ? std::nullopt : std::optional(member(key, *found));
}

JsonNode JsonNode::at(std::string const& key) const {
    if (auto const found = find(key))
        return *found;
    complain(fmt::format("no key {}, expected one{}", key, did_you_mean(key, keys_of(*value_))), ": ");
}

std::vector<JsonNode> JsonNode::items() const {
    if (!value_->is_array())
        fail("an array");
    std::vector<JsonNode> items;
    for (std::size_t i = 0; i < value_->size(); ++i)
        items.push_back({file_, fmt::format("{}[{}]", name_, i), (*value_)[i]});
    return items;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::members() const {
    require_object();
    std::vector<std::pair<std::string, JsonNode>> members;
    for (auto const& [key, value] : value_->items())
        members.emplace_back(key, member(key, value));
    return members;
}

std::vector<std::pair<int, JsonNode>> JsonNode::numbered() const {
    std::vector<std::pair<int, JsonNode>> numbered;
    for (auto const& [key, node] : members())
        if (auto const number = integer_of(key))  // others are remarks
            numbered.emplace_back(*number, node);
    return numbered;
}

int JsonNode::integer(int min) const {
    constexpr int max = std::numeric_limits<int>::max();
    double const given = value_->is_number() ? value_->get<double>() : 0.5;
    if (given != std::floor(given) || given < min || given > max)
        fail(fmt::format("an integer from {}", min));
    return static_cast<int>(given);
}

std::uint64_t JsonNode::unsigned_integer(std::uint64_t min, std::uint64_t max) const {
    if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() < min || value_->get<std::uint64_t>() > max)
        fail(fmt::format("an integer in {}..{}", min, max));
    return value_->get<std::uint64_t>();
}

double JsonNode::number() const {
    if (!value_->is_number())
        fail("a number");
    return value_->get<double>();
}

double JsonNode::number_above_zero() const {
    if (!(number() > 0))
        fail("a number above 0");
    return number();
}

std::vector<double> JsonNode::numbers(std::size_t count) const {
    std::vector<double> numbers;
    if (value_->is_array()) {
        for (JsonNode const& item : items()) {
            std::vector<double> const row =
                item.value_->is_array() ? item.numbers(item.value_->size()) : std::vector<double>{item.number()};
            numbers.insert(numbers.end(), row.begin(), row.end());
        }
    }
    if (!value_->is_array() || numbers.size() != count)
        fail(fmt::format("an array of {} numbers", count));
    return numbers;
}

std::string JsonNode::text() const {
    if (!value_->is_string())
        fail("text");
    return value_->get<std::string>();
}

void JsonNode::fail(std::string const& expected) const {
    complain(fmt::format("{}, expected {}", shown(*value_), expected), " = ");
}

void JsonNode::complain(std::string const& what, char const* after_name) const {
    throw InputError(fmt::format("{}: {}{}{}", *file_, name_, name_.empty() ? "" : after_name, what));
}

}  // namespace dataflow::io
