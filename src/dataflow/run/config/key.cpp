#include "dataflow/run/config/key.hpp"

#include <cmath>
#include <fmt/format.h>

namespace dataflow {
namespace {

/// What is accepted, in both wordings of it.
struct Accepted {
    std::string expectation;  ///< to follow "expected"
    std::string range;        ///< as a table has it
};

Accepted accepted(IntegerRange const& range) {
    if (range.max == std::numeric_limits<std::int64_t>::max())
        return {fmt::format("an integer, {} or more", range.min), fmt::format(">= {}", range.min)};
    return {fmt::format("an integer from {} to {}", range.min, range.max), fmt::format("{}..{}", range.min, range.max)};
}

Accepted accepted(NumberRange const& range) {
    if (std::isinf(range.min))
        return {"a number", "any number"};
    if (std::isinf(range.max) && range.excludes_min)
        return {fmt::format("a number above {}", range.min), fmt::format("> {}", range.min)};
    if (std::isinf(range.max))
        return {fmt::format("a number, {} or more", range.min), fmt::format(">= {}", range.min)};
    if (range.excludes_min)
        return {fmt::format("a number above {}, up to {}", range.min, range.max),
                fmt::format("> {}, up to {}", range.min, range.max)};
    return {fmt::format("a number from {} to {}", range.min, range.max), fmt::format("{}..{}", range.min, range.max)};
}

Accepted accepted(Key const& key) {
    switch (key.kind) {
        case KeyKind::boolean:
            return {"true or false", "true, false"};
        case KeyKind::integer:
            return accepted(key.integers);
        case KeyKind::number:
            return accepted(key.numbers);
        case KeyKind::choice: {
            std::string const choices = fmt::format("{}", fmt::join(key.choices, ", "));
            return {"one of " + choices, choices};
        }
        case KeyKind::path:
            return {"a path", "path"};
        case KeyKind::object:
            return {key.words.expectation, key.words.range};
        case KeyKind::vector:
            return {"a list of 3 numbers", "3 numbers"};
        case KeyKind::items:
            return {"a list of maps", "list of maps"};
    }
    return {};
}

}  // namespace

Key key_of(ItemField const& field) {
    Key key;
    key.text = field.text;
    key.kind = field.kind;
    key.words = field.words;
    return key;
}

bool is_bare_name(std::string const& object) { return object.find_first_of("/.") == std::string::npos; }

std::string expectation(Key const& key) { return accepted(key).expectation; }

std::string range_text(Key const& key) { return accepted(key).range; }

bool accepts(IntegerRange const& range, std::int64_t value) { return value >= range.min && value <= range.max; }

bool accepts(NumberRange const& range, double value) {
    return (range.excludes_min ? value > range.min : value >= range.min) && value <= range.max;
}

}  // namespace dataflow
