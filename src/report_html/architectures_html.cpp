#include "report_html/architectures_html.hpp"

#include <nlohmann/json.hpp>

#include "report_html/fill_page.hpp"
#include "report_html/page.hpp"

namespace faster::report {

std::string architectures_html(std::string const& title, std::vector<ArchitectureRow> const& rows) {
    using Json = nlohmann::json;
    Json table = Json::array();
    for (ArchitectureRow const& row : rows) {
        Json line = Json::parse(to_text(row));
        line["architecture"] = row.architecture;
        line["workload"] = row.workload;
        table.push_back(std::move(line));
    }
    return filled_page(architectures_page, title,
                       Json{{"rows", table}}.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace faster::report
