#pragma once

namespace faster::report {

/// The HTML report without its data: page/report.html with style and scripts in place. In the order in which they stand
/// there, `@title@` (twice) and `@data@` are to be replaced.
extern char const* const report_page;

}  // namespace faster::report
