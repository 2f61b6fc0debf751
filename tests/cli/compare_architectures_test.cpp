#include <catch2/catch.hpp>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace compare_architectures_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Words = std::vector<std::string>;

class Workspace {
  public:
    Workspace() {
        folder_.write("small.yaml",
                      "accelerator: {raster_cores: 2, window: 40}\n"
                      "workload: {object: banana, pose: {translation_m: [0, 0, 0.65]}, samples: {count: 3}}\n");
        folder_.write("empty.yaml", "accelerator: {raster_cores: 2, window: 20}\nworkload: {samples: {count: 1}}\n");
        folder_.write("plain.yaml", "accelerator: {}\n");
        folder_.write("quick.yaml", "accelerator: {inlier_unit: {neighbour_access: window}}\n");
        folder_.write("stuck.yaml", "accelerator: {fifos: {fragment_depth: {depth: 1}}}\n");
        folder_.write("no_mesh.yaml", "workload: {object: none.obj}\n");
        folder_.write("wrong.yaml", "workload: {samples: {count: 3}}\n");
    }
    CommandResult compare(Words arguments) const {
        arguments.insert(arguments.begin(), "compare-architectures");
        return run_command(FASTER_SIM_BINARY, arguments, folder_.path());
    }
    std::string text(std::string const& name) const { return content_of(folder_ / name); }
    std::size_t files() const { return entries_in(folder_.path()); }
    std::uint64_t cycles_of(Words const& settings) const {
        Words words{"run", "small.yaml", "--out", "out"};
        for (std::string const& setting : settings)
            words.insert(words.end(), {"--set", setting});
        require_done(run_command(FASTER_SIM_BINARY, words, folder_.path()));
        return nlohmann::json::parse(text("out/summary.json"))["total_cycles"];
    }

  private:
    TempFolder folder_;
};

/// Of a row of the CSV file.
std::uint64_t cycles_of(std::string const& row) {
    std::string const rest = row.substr(row.find(",finished,") + 10);
    return std::stoull(rest.substr(0, rest.find(',')));
}

TEST_CASE("compare-architectures finds what single runs find, in a table and a file", "[architectures]") {
    Workspace const workspace;
    CommandResult const result = workspace.compare({"plain.yaml", "quick.yaml", "stuck.yaml", "--workloads",
                                                    "small.yaml", "empty.yaml", "--csv", "a.csv", "--html", "a.html"});
    require_done(result);
    CHECK_THAT(workspace.text("a.html"),
               Contains("\"architecture\":\"stuck\"") && Contains("Chart.js") && Contains("Made by faster-sim"));
    std::vector<std::string> const table = lines_of(result.out);
    REQUIRE(table.size() >= 5);
    CHECK(table[0] == "| ms | small | empty | time, first = 1 | port conflict cycles | RAMB36 | LUT | FF | DSP |");
    CHECK_THAT(table[2], Contains("| plain | ") && Contains(" | 1.00 | "));
    CHECK_THAT(table[3], Contains("| quick | "));
    CHECK_THAT(table[4], Contains("| stuck | deadlock |"));
    std::vector<std::string> const rows = lines_of(workspace.text("a.csv"));
    REQUIRE(rows.size() == 7);
    std::uint64_t const plain = workspace.cycles_of({});
    std::uint64_t const quick = workspace.cycles_of({"accelerator.inlier_unit.neighbour_access=window"});
    CHECK(quick < plain);
    CHECK_THAT(rows[1], Catch::StartsWith("plain,small,finished," + std::to_string(plain) + ","));
    CHECK_THAT(rows[3], Catch::StartsWith("quick,small,finished," + std::to_string(quick) + ","));
    CHECK_THAT(rows[5], Catch::StartsWith("stuck,small,deadlock,,,,,,"));
}

TEST_CASE("compare-architectures does not depend on how many simulate at once", "[architectures]") {
    Workspace const workspace;
    Words const arguments{"plain.yaml", "quick.yaml", "--workloads", "small.yaml", "empty.yaml", "-j"};
    Words one = arguments, four = arguments;
    one.emplace_back("1");
    four.emplace_back("4");
    CHECK(workspace.compare(one).out == workspace.compare(four).out);
}

TEST_CASE("compare-architectures refuses bad input in one line, and writes nothing", "[architectures]") {
    Workspace const workspace;
    std::size_t const before = workspace.files();
    check_bad_input(workspace.compare({"wrong.yaml", "--workloads", "small.yaml", "--csv", "a.csv"}),
                    {"wrong.yaml:1: workload.samples.count, expected keys of accelerator only"});
    check_bad_input(workspace.compare({"none.yaml", "--workloads", "small.yaml"}), {"none.yaml", "no such file"});
    check_bad_input(workspace.compare({"inner_boarder", "--workloads", "small.yaml"}),
                    {"inner_boarder", "did you mean inner_border?"});
    check_bad_input(workspace.compare({"plain.yaml", "plain.yaml", "--workloads", "small.yaml"}),
                    {"plain.yaml", "each name once"});
    check_bad_input(workspace.compare({"plain.yaml", "--workloads", "small.yaml", "small.yaml"}), {"each name once"});
    check_bad_input(
        workspace.compare({"plain.yaml", "--workloads", "small.yaml", "--set", "accelerator.architecture=next"}),
        {"--set accelerator.architecture=next"});
    check_bad_input(workspace.compare({"plain.yaml", "--workloads", "no_mesh.yaml", "--csv", "a.csv"}), {"none.obj"});
    check_bad_input(workspace.compare({"plain.yaml", "--workloads", "small.yaml", "--set", "accelerator.cheese=1"}),
                    {"accelerator.cheese"});
    CHECK(workspace.files() == before);
}

TEST_CASE("compare-architectures knows the presets by name, and all of them without names", "[architectures]") {
    Workspace const workspace;
    CommandResult const named = workspace.compare({"line_buffers", "--workloads", "small.yaml", "--csv", "a.csv"});
    require_done(named);
    std::uint64_t const quick = workspace.cycles_of({"accelerator.inlier_unit.neighbour_access=window"});
    CHECK_THAT(lines_of(workspace.text("a.csv")).at(1),
               Catch::StartsWith("line_buffers,small,finished," + std::to_string(quick) + ","));
    CommandResult const all = workspace.compare({"--workloads", "empty.yaml"});
    require_done(all);
    CHECK_THAT(all.out, Contains("| faster | ") && Contains("| bounded | ") && Contains("| inner_border | "));
}

TEST_CASE("compare-architectures judges edge maps", "[architectures]") {
    Workspace const workspace;
    CommandResult const result = workspace.compare({"dual_map_4_1_2", "threshold", "--workloads", "small.yaml", "--set",
                                                    "accelerator.window=160", "--quality", "2", "--csv", "a.csv"});
    require_done(result);
    CHECK_THAT(result.out, Contains("| RAMB36 | LUT | FF | DSP | precision | recall | closed | thin |"));
    CHECK_THAT(lines_of(result.out).at(2), Contains(" | 100.0 % | 99.2 % | 50.0 % | 100.0 % |"));
    CHECK_THAT(lines_of(result.out).at(3), !Contains("100.0 %"));  // too thick, and edges inside the object
    CHECK_THAT(lines_of(workspace.text("a.csv")).at(1), Contains(",2,1.0000,0.9924,0.5000,1.0000,"));
}

TEST_CASE("Our own designs take a twentieth of the time on all five classes", "[architectures]") {
    TempFolder const folder;
    Words words{"compare-architectures",     "faster", "next",  "next_double_buffers", "--set",
                "workload.samples.count=60", "--csv",  "a.csv", "--workloads"};
    for (char const* const name : {"potted_meat_can", "banana", "mustard_bottle", "cracker_box", "tomato_soup_can"})
        words.push_back(FASTER_SOURCE_DIR "/configs/" + std::string(name) + ".yaml");
    require_done(run_command(FASTER_SIM_BINARY, words, folder.path()));
    std::vector<std::string> const rows = lines_of(content_of(folder / "a.csv"));
    REQUIRE(rows.size() == 16);
    for (std::size_t i = 1; i <= 5; ++i) {
        CAPTURE(rows[i], rows[i + 5], rows[i + 10]);
        CHECK(20 * cycles_of(rows[i + 5]) <= cycles_of(rows[i]));
        CHECK(20 * cycles_of(rows[i + 10]) <= cycles_of(rows[i]));
        CHECK(cycles_of(rows[i + 10]) <=
              cycles_of(rows[i + 5]) * 104 / 100);  // of so few samples, the last sweep counts
    }
}

TEST_CASE("Our own design takes a sixteenth of the time with the memory of the board", "[architectures]") {
    TempFolder const folder;
    require_done(run_command(FASTER_SIM_BINARY,
                             {"compare-architectures", "faster", "next_zcu102", "--set", "workload.samples.count=240",
                              "--csv", "a.csv", "--workloads", FASTER_SOURCE_DIR "/configs/cracker_box.yaml"},
                             folder.path()));
    std::vector<std::string> const rows = lines_of(content_of(folder / "a.csv"));
    REQUIRE(rows.size() == 3);
    CAPTURE(rows[1], rows[2]);
    CHECK(16 * cycles_of(rows[2]) <= cycles_of(rows[1]));
}

}  // namespace compare_architectures_test
