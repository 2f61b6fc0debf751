#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "dataflow/run/config/key_value.hpp"

namespace dataflow {

/// The value as people write it on the command line: text without the quotes of JSON.
inline std::string plain_text(KeyValue const& value) {
    auto const* const word = std::get_if<std::string>(&value);
    return word != nullptr ? *word : json_text(value);
}

/// What a word of a configuration means. Stricter than yaml-cpp's conversions, which also take `yes`, `0x2` and `2.0`
/// for an integer.

/// Decimal digits with an optional minus sign and without leading zeros (010 is eight to older YAML readers).
std::optional<std::int64_t> parse_integer(std::string_view text);

/// True for what has the form of an integer, even one beyond 64 bits.
bool is_integer_text(std::string_view text);

/// A finite decimal number: 2, -0.5, .5, 1e-3. Not inf, nan or hexadecimal.
std::optional<double> parse_number(std::string_view text);

/// `true` or `false`, as in YAML 1.2's JSON schema.
std::optional<bool> parse_boolean(std::string_view text);

/// True if YAML 1.2 reads the word as text, not as a boolean, a number or nothing.
bool is_plain_text(std::string_view text);

}  // namespace dataflow
