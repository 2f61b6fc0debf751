#pragma once
#include <string>

namespace faster::report {

/// The HTML report without its data: page/report.html with style and scripts in place. In the order in which they stand
/// there, `@title@` (twice) and `@data@` are to be replaced.
extern char const* const report_page;
/// The same of a sizing of FIFOs: page/sizing.html.
extern char const* const sizing_page;

/// A page with its title and its data, a JSON object, in place.
std::string filled_page(char const* page, std::string const& title, std::string const& data);

}  // namespace faster::report
