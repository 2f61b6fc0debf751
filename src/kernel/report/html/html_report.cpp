#include "kernel/report/html/html_report.hpp"

#include "kernel/config/configuration_hash.hpp"
#include "kernel/report/html/fill_page.hpp"
#include "kernel/report/html/page.hpp"
#include "kernel/report/html/report_data.hpp"
#include "kernel/report/provenance.hpp"

namespace faster::report {

std::string html_report(HtmlReportInput const& input) {
    return filled_page(report_page, input.title, made_by_html(configuration_hash(input.keys)), report_data(input));
}

}  // namespace faster::report
