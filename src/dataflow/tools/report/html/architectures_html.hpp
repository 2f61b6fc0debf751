#pragma once
#include <string>
#include <vector>

#include "kernel/report/architecture_table.hpp"

namespace faster::report {

/// One HTML page of architectures side by side, that needs nothing else.
std::string architectures_html(std::string const& title, std::vector<ArchitectureRow> const& rows);

}  // namespace faster::report
