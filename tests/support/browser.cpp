#include "support/browser.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/report_page.hpp"

namespace faster::test {

using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

namespace {

/// Empty if it is not installed.
std::string path_of_chromium() {
    std::istringstream folders(std::getenv("PATH") == nullptr ? "" : std::getenv("PATH"));
    for (std::string folder; std::getline(folders, folder, ':');)
        if (std::filesystem::exists(folder + "/" + chromium))
            return folder + "/" + chromium;
    return "";
}

}  // namespace

bool browser_is_missing() {
    if (!path_of_chromium().empty())
        return false;
    WARN("skipped: " << chromium << " is not installed (scripts/setup.sh --dev installs it)");
    return true;
}

std::string drawn_page(TempFolder const& folder, std::string const& file, Words const& options) {
    Words arguments{"--no-sandbox",  // CI is root in a container
                    "--disable-gpu",
                    "--disable-dev-shm-usage",
                    "--allow-file-access-from-files",
                    "--enable-logging=stderr",
                    "--virtual-time-budget=10000",
                    "--window-size=1280,2400",
                    "--user-data-dir=" + (folder / "profile").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    arguments.insert(arguments.end(), {"--dump-dom", "file://" + (folder / file).string()});
    CommandResult const result = run_command(path_of_chromium(), arguments, folder.path());
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    REQUIRE(result.err.find(":CONSOLE") == std::string::npos);
    return result.out;
}

Json self_check(TempFolder const& folder, std::string const& file, Words const& options) {
    Json check = json_element(drawn_page(folder, file + "#self-check", options), "self-check");
    CHECK(check["errors"] == Json::array());
    CHECK(check["painted"] == check["charts"]);
    CHECK(check["page_width"] <= check["window_width"]);  // nothing makes the page itself scroll sideways
    return check;
}

}  // namespace faster::test
