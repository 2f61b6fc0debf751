#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace dataflow {

/// A character of UTF-8 text.
struct Utf8Character {
    std::size_t bytes = 1;  ///< that it takes
    char32_t code = 0;
    bool is_valid = false;  ///< false: a byte that starts no character; overlong forms and surrogates are none
};

/// The character at the begin of a text that is not empty.
Utf8Character first_character(std::string_view text);

/// False for what moves the cursor or changes the order of what is seen: control characters (C0, DEL, C1), line
/// separators, bidirectional marks, tags.
bool is_printable(char32_t code);

/// Where a byte sequence stops being printable UTF-8 (tabs and line ends are fine), from 0; none if it never does.
std::optional<std::size_t> first_bad_byte(std::string_view text);

}  // namespace dataflow
