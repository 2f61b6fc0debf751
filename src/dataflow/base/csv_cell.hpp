#pragma once
#include <string>
#include <string_view>

#include "dataflow/base/printable.hpp"

namespace dataflow {

/// A name or a value from outside as a cell of a CSV table: printable(), and in quotes if it has a comma or a quote.
inline std::string csv_cell(std::string_view value) {
    std::string const text = printable(value);
    if (text.find_first_of(",\"") == std::string::npos)
        return text;
    std::string cell = "\"";
    for (char const letter : text)
        cell += letter == '"' ? std::string("\"\"") : std::string(1, letter);
    return cell + '"';
}

}  // namespace dataflow
