#pragma once
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace dataflow {

/// Adds a line to a text.
template <class... Arguments>
void put_line(std::string& text, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text), format, std::forward<Arguments>(arguments)...);
    text += '\n';
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
