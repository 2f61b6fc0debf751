#pragma once
#include <string>
#include <string_view>

namespace faster::report {

/// A page as the build joins them, with its title (any text) in place of the two `@title@`, and its data (JSON) in
/// place of the `@data@` that follows.
std::string filled_page(std::string_view page, std::string const& title, std::string const& data);

}  // namespace faster::report
