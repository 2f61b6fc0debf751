#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/temp_folder.hpp"

namespace faster::test {

/// Chromium without a window, which starts in a quarter of the time.
inline constexpr char const* chromium = "chromium-headless-shell";

/// CTest reports a test that prints this as skipped.
bool browser_is_missing();

/// The page of a file in `folder` after its script ran. Anything on the console is an error: the page writes nothing.
std::string drawn_page(TempFolder const& folder, std::string const& file, std::vector<std::string> const& options = {});

/// What the page found out about itself.
nlohmann::ordered_json self_check(TempFolder const& folder, std::string const& file,
                                  std::vector<std::string> const& options = {});

}  // namespace faster::test
