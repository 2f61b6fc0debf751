#pragma once
#include <string>
#include <vector>

#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/report/html/packed_timeline.hpp"

namespace dataflow::report {

/// A picture to show as it is.
struct ReportPicture {
    std::string title;
    std::string png;  ///< the bytes of the file
};

/// What the HTML report of a finished run is made from. Referred to, not kept.
struct HtmlReportInput {
    std::string title;  ///< of the page, e.g. the name of the configuration
    RunStatistics const& run;
    std::vector<ResolvedKey> const& keys;
    std::vector<PackedTimeline> const& timelines;  ///< none: no timeline, no occupancies
    std::vector<ReportPicture> const& pictures;
};

/// One HTML page that needs nothing else: no network, no other file. Simulated figures only, so equal runs give equal
/// bytes.
std::string html_report(HtmlReportInput const& input);

}  // namespace dataflow::report
