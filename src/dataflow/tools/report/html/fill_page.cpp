#include "dataflow/tools/report/html/fill_page.hpp"

#include "dataflow/base/markup_text.hpp"
#include "dataflow/base/printable.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/tools/report/html/html_text.hpp"

namespace dataflow::report {

/// Takes the page up to `marker` off the front of `rest`, and the marker with it.
static std::string_view take_until(std::string_view& rest, std::string_view marker) {
    std::size_t const end = rest.find(marker);
    std::string_view const taken = rest.substr(0, end);
    rest.remove_prefix(end + marker.size());
    return taken;
}

std::string filled_page(std::string_view page, std::string const& title, std::string const& made_by_html,
                        std::string const& data) {
    std::string const name = markup_escaped(printable(title));
    std::string const program = markup_escaped(printable(program_name()));
    std::string html;
    // In the browser's tab, and in the headline below the program's name.
    html.append(take_until(page, "@title@")).append(name);
    html.append(take_until(page, "@program@")).append(program);
    html.append(take_until(page, "@program@")).append(program);
    html.append(take_until(page, "@title@")).append(name);
    html.append(take_until(page, "@made_by@")).append(made_by_html);
    html.append(take_until(page, "@data@")).append(script_safe(data));
    return html.append(page);
}

}  // namespace dataflow::report
