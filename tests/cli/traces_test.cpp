#include <algorithm>
#include <catch2/catch.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace traces_test {

using namespace faster::test;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

fs::path const traces = fs::path(FASTER_SOURCE_DIR) / "traces";
Words const tables{"samples.csv", "fifos.csv", "loops.csv"};

/// Folders of traces/, by name.
Words trace_names() {
    Words names;
    for (auto const& entry : fs::directory_iterator(traces))
        if (entry.is_directory())
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

/// Replays a trace on the machine of the main job. Its tables are in OUT afterwards.
void replay(std::string const& name, int cores, std::string const& engine, fs::path const& out) {
    require_done_with_warnings(  // some draw nothing
        run_command(FASTER_SIM_BINARY,
                    {"run", (fs::path(FASTER_SOURCE_DIR) / "configs" / "faster_zcu102.yaml").string(), "--trace",
                     (traces / name).string(), "--set", "accelerator.raster_cores=" + std::to_string(cores), "--set",
                     "simulation.engine=" + engine, "--out", out.string()},
                    out.parent_path()));
}

/// Where two texts differ first, for people; empty if they are the same bytes.
std::string first_difference(std::string const& found, std::string const& expected) {
    if (found == expected)
        return {};
    Words const ours = lines_of(found);
    Words const theirs = lines_of(expected);
    for (std::size_t i = 0; i < std::min(ours.size(), theirs.size()); ++i)
        if (ours[i] != theirs[i])
            return "line " + std::to_string(i + 1) + ": " + ours[i] + " against " + theirs[i];
    return std::to_string(ours.size()) + " lines against " + std::to_string(theirs.size());
}

void check_expected_tables(std::string const& engine) {
    TempFolder const folder;
    for (std::string const& name : trace_names()) {
        fs::path const out = folder / name;
        replay(name, 2, engine, out);
        for (std::string const& table : tables) {
            CAPTURE(name, engine, table);
            std::string const expected = content_of(traces / name / "expected" / table);
            REQUIRE_FALSE(expected.empty());
            CHECK(first_difference(content_of(out / table), expected) == "");
        }
    }
}

/// end_cycle of the last row of a samples.csv.
std::uint64_t last_end_cycle(std::string const& samples) {
    std::istringstream row(lines_of(samples).back());
    std::string field;
    for (int column = 0; column < 4; ++column)
        std::getline(row, field, ',');
    return std::stoull(field);
}

TEST_CASE("The stored traces are there, and each is explained") {
    Words const names = trace_names();
    CHECK(names == Words{"banana", "cracker_box", "edge_heavy", "empty", "fragment_heavy", "full_window",
                         "mustard_bottle", "one_triangle", "potted_meat_can", "tomato_soup_can"});
    std::string const readme = content_of(traces / "README.md");
    for (std::string const& name : names)
        CHECK_THAT(readme, Catch::Matchers::Contains("`" + name + "`"));
}

TEST_CASE("Every stored trace gives its expected tables with the decoupled engine") {
    check_expected_tables("decoupled");
}

TEST_CASE("Every stored trace gives its expected tables with the lockstep engine") {
    check_expected_tables("lockstep");
}

/// In a window whose centre is in that column, with five lanes.
std::string samples_with_lanes(TempFolder const& folder, std::string const& col) {
    fs::remove_all(folder / "trace");
    fs::copy(traces / "one_triangle", folder / "trace", fs::copy_options::recursive);
    folder.write("empty.yaml", "");
    folder.write("trace/samples.csv",
                 "sample,centre_row,centre_col,first_triangle,triangle_count\n0,24," + col + ",0,1\n");
    require_done_with_warnings(
        run_command(FASTER_SIM_BINARY,
                    {"run", "empty.yaml", "--trace", "trace", "--set", "accelerator.architecture=next", "--out", "out"},
                    folder.path()));
    return content_of(folder / "out" / "samples.csv");
}

TEST_CASE("However far a window is from the image, its columns keep their lanes") {
    TempFolder const folder;
    for (int const lane : {0, 1, 2, 3, 4}) {
        std::string const near = samples_with_lanes(folder, std::to_string(100 + lane));
        for (int const far : {10000, 1000000000, -10000, -1000000000})
            CHECK(samples_with_lanes(folder, std::to_string(far + lane)) == near);
    }
}

TEST_CASE("The trace without triangles takes the cycles of the closed form on one core") {
    constexpr std::uint64_t pixels = 32 * 32;
    constexpr std::uint64_t samples = 4;
    TempFolder const folder;
    for (std::string const& engine : Words{"decoupled", "lockstep"}) {
        CAPTURE(engine);
        replay("empty", 1, engine, folder / engine);
        std::uint64_t const total = last_end_cycle(content_of(folder / engine / "samples.csv")) + 1;
        CHECK(total == 4 * pixels + 15 + (samples - 1) * (4 * pixels + 10));
    }
}

}  // namespace traces_test
