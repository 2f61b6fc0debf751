#include "dataflow/run/config/plain_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <system_error>

namespace dataflow {

namespace {

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

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

}  // namespace dataflow
