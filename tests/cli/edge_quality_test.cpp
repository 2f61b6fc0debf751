#include <catch2/catch.hpp>
#include <filesystem>
#include <string>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/decoded_png.hpp"
#include "support/on_terminal.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace edge_quality_test {

using namespace faster::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

CommandResult judge(TempFolder const& folder, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "edge-quality");
    return run_command(FASTER_SIM_BINARY, arguments, folder.path());
}

TEST_CASE("edge-quality prints a table, and writes the rows and two pictures of each", "[quality]") {
    TempFolder const folder;
    CommandResult const result = judge(
        folder, {"--poses", "3", "--classes", "mug,banana", "--algorithms", "bounded,transition", "--out", "quality"});
    require_done(result);
    CHECK(lines_of(result.out).size() == 6);
    auto const lines = lines_of(content_of(folder / "quality" / "quality.csv"));
    REQUIRE(lines.size() == 5);
    CHECK(lines[1].rfind("bounded,mug,3,", 0) == 0);
    CHECK(lines[4].rfind("transition,banana,3,", 0) == 0);
    for (char const* const picture : {"bounded_mug_best.png", "transition_banana_worst.png"}) {
        auto const header = header_of_decoded(content_of(folder / "quality" / "pictures" / picture));
        CHECK(header.height == 600);
        CHECK(header.width == 600);
    }
}

TEST_CASE("edge-quality and grip show on a terminal how long they will take", "[quality][grip]") {
    std::string const quality = output_on_terminal(
        FASTER_SIM_BINARY, {"edge-quality", "--poses", "60", "--classes", "mug,banana", "--algorithms", "bounded"}, {});
    CHECK_THAT(quality, Contains("/120 edge maps, ") && Contains(" s left") && Contains("| bounded |"));
    std::string const config = FASTER_SOURCE_DIR "/configs/banana.yaml";
    std::string const grip =
        output_on_terminal(FASTER_SIM_BINARY, {"grip", config, "--set", "workload.samples.count=3000", "-j", "1"}, {});
    CHECK_THAT(grip, Contains("/3000 samples by GRIP, ") && Contains("/3000 samples by the design, "));
}

TEST_CASE("edge-quality refuses what it does not know in one line", "[quality]") {
    TempFolder const folder;
    check_bad_input(judge(folder, {"--classes", "mugg", "--out", "quality"}),
                    {"--classes mugg", "expected one of", "did you mean mug?"});
    check_bad_input(judge(folder, {"--algorithms", "dualmap"}), {"--algorithms dualmap", "did you mean dual_map?"});
    check_bad_input(judge(folder, {"--poses", "0"}), {"--poses"});
    CHECK_FALSE(fs::exists(folder / "quality"));
}

}  // namespace edge_quality_test
