#pragma once
#include <string>
#include <string_view>

namespace dataflow::report {

/// JSON as the content of a script element: still the same JSON, without anything that could end the element.
std::string script_safe(std::string_view json);

/// RFC 4648, with padding.
std::string base64(std::string_view bytes);

}  // namespace dataflow::report
