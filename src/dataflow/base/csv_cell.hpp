#pragma once
#include <cstdlib>
#include <string>
#include <string_view>

#include "dataflow/base/printable.hpp"
#include "dataflow/base/text_lines.hpp"

namespace dataflow {

/// Whether a spreadsheet takes a cell for a formula, and works it out: `=cmd|...` may start a program.
inline bool is_formula(std::string const& text) {
    constexpr std::string_view signs = "+-", starts = "=@";
    if (text.empty() || starts.find(text.front()) != std::string_view::npos)
        return !text.empty();
    char* end = nullptr;
    return signs.find(text.front()) != std::string_view::npos &&
           (std::strtod(text.c_str(), &end), *end != '\0' || end == text.c_str());  // all of a number is one
}

/// A name or a value from outside as a cell of a CSV table: printable(), with a ' in front if it would be a formula,
/// and in quotes if it has a comma or a quote.
inline std::string csv_cell(std::string_view value) {
    std::string text = printable(value);
    if (is_formula(text))
        text.insert(0, "'");
    if (text.find_first_of(",\"") == std::string::npos)
        return text;
    return '"' + with_replaced(text, {{'"', "\"\""}}) + '"';
}

}  // namespace dataflow
