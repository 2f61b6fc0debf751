#include "kernel/config/plain_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace faster {
namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Bytes of the UTF-8 character that starts with `lead`; 0 if none does. C0, C1 and F5 upwards never occur.
std::size_t character_length(unsigned char lead) {
    if (lead < 0x80) {
        bool const is_control = (lead < 0x20 && lead != '\t' && lead != '\n' && lead != '\r') || lead == 0x7F;
        return is_control ? 0 : 1;
    }
    if (lead >= 0xC2 && lead <= 0xDF) {
        return 2;
    }
    if (lead >= 0xE0 && lead <= 0xEF) {
        return 3;
    }
    return lead >= 0xF0 && lead <= 0xF4 ? 4 : 0;
}

/// Excludes overlong forms, surrogates and code points beyond 10FFFF, all recognisable by the second byte.
bool is_second_byte(unsigned char lead, unsigned char second) {
    switch (lead) {
        case 0xE0:
            return second >= 0xA0 && second <= 0xBF;
        case 0xED:
            return second >= 0x80 && second <= 0x9F;
        case 0xF0:
            return second >= 0x90 && second <= 0xBF;
        case 0xF4:
            return second >= 0x80 && second <= 0x8F;
        default:
            return second >= 0x80 && second <= 0xBF;
    }
}

bool is_character(std::string_view bytes) {
    auto const byte = [&](std::size_t index) { return static_cast<unsigned char>(bytes[index]); };
    if (bytes.size() > 1 && !is_second_byte(byte(0), byte(1))) {
        return false;
    }
    for (std::size_t index = 2; index < bytes.size(); ++index) {
        if (byte(index) < 0x80 || byte(index) > 0xBF) {
            return false;
        }
    }
    return true;
}

bool is_null_word(std::string_view text) {
    return text.empty() || text == "~" || text == "null" || text == "Null" || text == "NULL";
}

bool is_boolean_word(std::string_view text) {
    constexpr std::string_view words[] = {"true", "True", "TRUE", "false", "False", "FALSE"};
    return std::find(std::begin(words), std::end(words), text) != std::end(words);
}

}  // namespace

bool is_integer_text(std::string_view text) {
    if (!text.empty() && text.front() == '-') {
        text.remove_prefix(1);
    }
    bool const has_leading_zero = text.size() > 1 && text.front() == '0';
    return !text.empty() && !has_leading_zero && std::all_of(text.begin(), text.end(), is_digit);
}

std::optional<std::int64_t> parse_integer(std::string_view text) {
    std::int64_t value = 0;
    if (!is_integer_text(text) || std::from_chars(text.data(), text.data() + text.size(), value).ec != std::errc{}) {
        return std::nullopt;
    }
    return value;
}

std::optional<double> parse_number(std::string_view text) {
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') {
        text.remove_prefix(1);
    }
    if (text.find_first_not_of("0123456789+-.eE") != std::string_view::npos) {
        return std::nullopt;
    }
    double value = 0;
    auto const result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc{} || result.ptr != text.data() + text.size() || !std::isfinite(value)) {
        return std::nullopt;
    }
    return value;
}

std::optional<bool> parse_boolean(std::string_view text) {
    if (text == "true") {
        return true;
    }
    return text == "false" ? std::optional<bool>{false} : std::nullopt;
}

bool is_plain_text(std::string_view text) {
    return !is_null_word(text) && !is_boolean_word(text) && !is_integer_text(text) && !parse_number(text);
}

std::optional<std::size_t> first_bad_byte(std::string_view text) {
    for (std::size_t index = 0; index < text.size();) {
        std::size_t const length = character_length(static_cast<unsigned char>(text[index]));
        if (length == 0 || index + length > text.size() || !is_character(text.substr(index, length))) {
            return index;
        }
        index += length;
    }
    return std::nullopt;
}

std::string shortened(std::string_view text) {
    constexpr std::size_t longest = 80;
    std::size_t cut = std::min(longest, text.size());
    while (cut < text.size() && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) {
        --cut;  // not inside a character
    }
    std::string line(text.substr(0, cut));
    std::replace_if(
        line.begin(), line.end(), [](char letter) { return static_cast<unsigned char>(letter) < 0x20; }, ' ');
    return cut < text.size() ? line + "..." : line;
}

}  // namespace faster
