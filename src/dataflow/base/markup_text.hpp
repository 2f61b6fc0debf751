#pragma once
#include <string>
#include <string_view>

#include "dataflow/base/text_lines.hpp"

namespace dataflow {

/// Text as the content of an HTML or XML element or a quoted attribute.
inline std::string markup_escaped(std::string_view text) {
    return with_replaced(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'\'', "&#39;"}});
}

}  // namespace dataflow
