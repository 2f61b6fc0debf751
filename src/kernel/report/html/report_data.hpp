#pragma once
#include <string>

#include "kernel/report/html/html_report.hpp"

namespace faster::report {

/// All figures, names and pictures of the HTML report as one JSON object on one line; docs/formats.md describes it.
std::string report_data(HtmlReportInput const& input);

}  // namespace faster::report
