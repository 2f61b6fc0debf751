#include "dataflow/run/config/key.hpp"

#include <cmath>
#include <fmt/format.h>

namespace dataflow {
namespace {

bool is_open(IntegerRange const& range) { return range.max == std::numeric_limits<std::int64_t>::max(); }

std::string expected_integer(IntegerRange const& range) {
    if (is_open(range)) {
        return fmt::format("an integer, {} or more", range.min);
    }
    return fmt::format("an integer from {} to {}", range.min, range.max);
}

std::string expected_number(NumberRange const& range) {
    if (std::isinf(range.min)) {
        return "a number";
    }
    if (std::isinf(range.max)) {
        return range.excludes_min ? fmt::format("a number above {}", range.min)
                                  : fmt::format("a number, {} or more", range.min);
    }
    if (range.excludes_min)
        return fmt::format("a number above {}, up to {}", range.min, range.max);
    return fmt::format("a number from {} to {}", range.min, range.max);
}

std::string integer_range(IntegerRange const& range) {
    return is_open(range) ? fmt::format(">= {}", range.min) : fmt::format("{}..{}", range.min, range.max);
}

std::string number_range(NumberRange const& range) {
    if (std::isinf(range.min)) {
        return "any number";
    }
    if (std::isinf(range.max)) {
        return fmt::format("{} {}", range.excludes_min ? ">" : ">=", range.min);
    }
    if (range.excludes_min)
        return fmt::format("> {}, up to {}", range.min, range.max);
    return fmt::format("{}..{}", range.min, range.max);
}

}  // namespace

Key key_of(ItemField const& field) {
    Key key;
    key.text = field.text;
    key.kind = field.kind;
    key.words = field.words;
    return key;
}

std::string expectation(Key const& key) {
    switch (key.kind) {
        case KeyKind::boolean:
            return "true or false";
        case KeyKind::integer:
            return expected_integer(key.integers);
        case KeyKind::number:
            return expected_number(key.numbers);
        case KeyKind::choice:
            return fmt::format("one of {}", fmt::join(key.choices, ", "));
        case KeyKind::path:
            return "a path";
        case KeyKind::object:
            return key.words.expectation;
        case KeyKind::vector:
            return "a list of 3 numbers";
        case KeyKind::items:
            return "a list of maps";
    }
    return {};
}

std::string range_text(Key const& key) {
    switch (key.kind) {
        case KeyKind::boolean:
            return "true, false";
        case KeyKind::integer:
            return integer_range(key.integers);
        case KeyKind::number:
            return number_range(key.numbers);
        case KeyKind::choice:
            return fmt::format("{}", fmt::join(key.choices, ", "));
        case KeyKind::path:
            return "path";
        case KeyKind::object:
            return key.words.range;
        case KeyKind::vector:
            return "3 numbers";
        case KeyKind::items:
            return "list of maps";
    }
    return {};
}

bool accepts(IntegerRange const& range, std::int64_t value) { return value >= range.min && value <= range.max; }

bool accepts(NumberRange const& range, double value) {
    return (range.excludes_min ? value > range.min : value >= range.min) && value <= range.max;
}

}  // namespace dataflow
