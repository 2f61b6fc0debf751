#pragma once
namespace dataflow::report {

/// The HTML report without its data: page/report.html with style and scripts in place; see filled_page().
extern char const* const report_page;
/// The page of a run that got stuck, without its data: page/deadlock.html.
extern char const* const deadlock_page;

}  // namespace dataflow::report
