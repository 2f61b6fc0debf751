#pragma once
#include <string>

namespace dataflow::report {

/// One HTML page of a sizing of FIFOs, that needs nothing else. `json`: its sizing.json (docs/formats.md).
std::string sizing_html(std::string const& title, std::string const& configuration_hash, std::string const& json);

}  // namespace dataflow::report
