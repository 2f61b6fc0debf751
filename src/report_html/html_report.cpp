#include "report_html/html_report.hpp"

#include <string_view>

#include "common/markup_text.hpp"
#include "report_html/html_text.hpp"
#include "report_html/page.hpp"
#include "report_html/report_data.hpp"

namespace faster::report {

/// Takes the page up to `marker` off the front of `rest`, and the marker with it.
static std::string_view take_until(std::string_view& rest, std::string_view marker) {
    std::size_t const end = rest.find(marker);
    std::string_view const taken = rest.substr(0, end);
    rest.remove_prefix(end + marker.size());
    return taken;
}

std::string filled_page(char const* page, std::string const& title, std::string const& data) {
    std::string const escaped = markup_escaped(title);
    std::string_view rest = page;
    std::string html;
    for (int use = 0; use < 2; ++use)  // in the browser's tab and in the headline
        html.append(take_until(rest, "@title@")).append(escaped);
    html.append(take_until(rest, "@data@")).append(script_safe(data));
    return html.append(rest);
}

std::string html_report(HtmlReportInput const& input) {
    return filled_page(report_page, input.title, report_data(input));
}

}  // namespace faster::report
