#include "report_html/html_report.hpp"

#include "report_html/fill_page.hpp"
#include "report_html/page.hpp"
#include "report_html/report_data.hpp"

namespace faster::report {

std::string html_report(HtmlReportInput const& input) {
    return filled_page(report_page, input.title, report_data(input));
}

}  // namespace faster::report
