#pragma once
#include <string>
#include <string_view>

namespace dataflow::report {

/// A page as the build joins them, with its title (any text) in place of the two `@title@`, the program's name in place
/// of the two `@program@` between them, and what follows there: HTML of made_by_html() for `@made_by@`, and its data
/// (JSON) for `@data@`.
std::string filled_page(std::string_view page, std::string const& title, std::string const& made_by_html,
                        std::string const& data);

}  // namespace dataflow::report
