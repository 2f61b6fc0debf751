#include "dataflow/tools/report/html/architectures_html.hpp"

#include <nlohmann/json.hpp>

#include "dataflow/tools/report/html/fill_page.hpp"
#include "dataflow/tools/report/html/page.hpp"
#include "dataflow/tools/report/provenance.hpp"

namespace dataflow::report {

std::string architectures_html(std::string const& title, std::vector<ArchitectureRow> const& rows) {
    nlohmann::json table = nlohmann::json::array();
    for (ArchitectureRow const& row : rows) {
        nlohmann::json line = nlohmann::json::parse(to_text(row));
        line["architecture"] = row.architecture;
        line["workload"] = row.workload;
        table.push_back(std::move(line));
    }
    return filled_page(architectures_page, title, made_by_html(""),
                       nlohmann::json{{"rows", table}}.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
}

}  // namespace dataflow::report
