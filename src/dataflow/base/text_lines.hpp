#pragma once
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dataflow {

/// Adds a line to a text.
template <class... Arguments>
void put_line(std::string& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    text += '\n';
}

/// Without the blanks and ends of lines around it.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r\n";
    std::size_t const first = std::min(text.find_first_not_of(blanks), text.size());
    return text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

/// A text in which what stands beside a letter takes its place.
inline std::string with_replaced(std::string_view text,
                                 std::initializer_list<std::pair<char, std::string_view>> replacements) {
    std::string replaced;
    replaced.reserve(text.size());
    for (char const letter : text) {
        auto const* const found = std::find_if(replacements.begin(), replacements.end(),
                                               [letter](auto const& pair) { return pair.first == letter; });
        if (found == replacements.end())
            replaced += letter;
        else
            replaced += found->second;
    }
    return replaced;
}

/// The parts of a dotted name: "fifos", "lines", "max_occupancy".
inline std::vector<std::string> split_at_points(std::string_view name) {
    std::vector<std::string> parts(1);
    for (char const letter : name)
        if (letter == '.')
            parts.emplace_back();
        else
            parts.back() += letter;
    return parts;
}

/// The text behind the mark that some editors put before UTF-8.
inline std::string_view without_byte_order_mark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.substr(0, mark.size()) == mark ? text.substr(mark.size()) : text;
}

/// Of each column that of its widest cell.
template <std::size_t Columns>
std::array<std::size_t, Columns> widths_of(std::vector<std::array<std::string, Columns>> const& rows) {
    std::array<std::size_t, Columns> widths{};
    for (auto const& row : rows)
        for (std::size_t i = 0; i < Columns; ++i)
            widths[i] = std::max(widths[i], row[i].size());
    return widths;
}

}  // namespace dataflow
