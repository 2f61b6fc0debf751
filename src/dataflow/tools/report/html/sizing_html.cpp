#include "kernel/report/html/sizing_html.hpp"

#include "kernel/report/html/fill_page.hpp"
#include "kernel/report/html/page.hpp"
#include "kernel/report/provenance.hpp"

namespace faster::report {

std::string sizing_html(std::string const& title, std::string const& configuration_hash, std::string const& json) {
    return filled_page(sizing_page, title, made_by_html(configuration_hash), json);
}

}  // namespace faster::report
