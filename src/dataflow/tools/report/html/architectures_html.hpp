#pragma once
#include <string>
#include <vector>

#include "dataflow/tools/report/architecture_table.hpp"

namespace dataflow::report {

/// One HTML page of architectures side by side, that needs nothing else.
std::string architectures_html(std::string const& title, std::vector<ArchitectureRow> const& rows);

}  // namespace dataflow::report
