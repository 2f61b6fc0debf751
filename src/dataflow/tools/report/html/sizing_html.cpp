#include "dataflow/tools/report/html/sizing_html.hpp"

#include "dataflow/tools/report/html/fill_page.hpp"
#include "dataflow/tools/report/html/page.hpp"
#include "dataflow/tools/report/provenance.hpp"

namespace dataflow::report {

std::string sizing_html(std::string const& title, std::string const& configuration_hash, std::string const& json) {
    return filled_page(sizing_page, title, made_by_html(configuration_hash), json);
}

}  // namespace dataflow::report
