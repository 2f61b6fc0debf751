#pragma once
#include <string>
#include <string_view>

namespace dataflow {

/// Text as the content of an HTML or XML element or a quoted attribute.
inline std::string markup_escaped(std::string_view text) {
    std::string escaped;
    for (char const letter : text) {
        if (letter == '&')
            escaped += "&amp;";
        else if (letter == '<')
            escaped += "&lt;";
        else if (letter == '>')
            escaped += "&gt;";
        else if (letter == '"')
            escaped += "&quot;";
        else if (letter == '\'')
            escaped += "&#39;";
        else
            escaped += letter;
    }
    return escaped;
}

}  // namespace dataflow
