#include <algorithm>
#include <catch2/catch.hpp>
#include <regex>

#include "dataflow/base/grouped_digits.hpp"
#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/small_workspace.hpp"
#include "support/tool_output.hpp"

namespace size_fifos_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

/// The event file of a run of config.yaml on a window that is small enough to be sized quickly.
class Workspace {
  public:
    Workspace() {
        require_done(tool({"run", "config.yaml", "--events", "events", "--set", "accelerator.window=24", "--set",
                           "workload.samples.count=2"}));
    }

    CommandResult tool(Words const& words) const { return run_command(FASTER_SIM_BINARY, words, folder().path()); }
    CommandResult size(Words words) const {
        words.insert(words.begin(), {"size-fifos", "events"});
        return tool(words);
    }
    /// Of config.yaml with sizes/depths.yaml over it, simulated.
    std::uint64_t cycles_of_depths() const {
        folder().write("depths_sweep.yaml",
                       "format: faster-sweep\nversion: 1\nbase: config.yaml\n"
                       "set: {accelerator.window: 24, workload.samples.count: 2}\n"
                       "dimensions:\n  - {overlay: depths, files: [sizes/depths.yaml]}\n");
        require_done(tool({"sweep", "depths_sweep.yaml", "--out", "swept"}));
        std::string const row = lines_of(text("swept/results.csv")).at(1);
        std::string const before = "0,sizes/depths.yaml,done,";
        REQUIRE(row.rfind(before, 0) == 0);
        return std::stoull(row.substr(before.size()));
    }
    std::string text(std::string const& name) const { return small_.text(name); }
    Json json(std::string const& name) const { return Json::parse(text(name)); }
    bool has(std::string const& name) const { return std::filesystem::exists(folder() / name); }
    TempFolder const& folder() const { return small_.folder(); }

  private:
    SmallWorkspace small_;
};

/// Of a report.
std::uint64_t total_cycles(std::string const& report) {
    std::smatch match;
    REQUIRE(std::regex_search(report, match, std::regex("total  ([0-9,]+) cycles")));
    std::string digits = match[1];
    digits.erase(std::remove(digits.begin(), digits.end(), ','), digits.end());
    return std::stoull(digits);
}

TEST_CASE("size-fifos writes depths that whatif and a run confirm") {
    Workspace const workspace;
    CommandResult const result = workspace.size({"--within", "2", "--out", "sizes", "--points", "3"});
    require_done(result);
    Json const sizing = workspace.json("sizes/sizing.json");
    CHECK(sizing["format"] == "faster-sizing");
    CHECK(sizing["proven"] == true);
    auto const unbounded = sizing["unbounded"]["total_cycles"].get<std::uint64_t>();
    auto const answer = sizing["answer"]["total_cycles"].get<std::uint64_t>();
    CHECK(sizing["bound_cycles"].get<std::uint64_t>() == unbounded + unbounded * 2 / 100);
    CHECK(answer <= sizing["bound_cycles"].get<std::uint64_t>());
    CHECK_THAT(result.out, Contains("Proven: nothing below ") && Contains(" LUT-equivalents keeps the bound."));
    CHECK_THAT(result.out, Contains(dataflow::grouped(answer)));

    CHECK(workspace.cycles_of_depths() == answer);

    REQUIRE(sizing["certificate"].size() > 0);
    for (Json const& row : sizing["certificate"]) {
        CAPTURE(row.dump());
        Words words{"whatif", "events", "--full"};
        for (Json const& fifo : sizing["fifos"]) {
            auto const name = fifo["fifo"].get<std::string>();
            Json const& depth = name == row["fifo"] ? row["shallower_depth"] : fifo["depth"];
            words.insert(words.end(), {"--set", "accelerator.fifos." + name + ".depth=" + depth.dump()});
        }
        CommandResult const shallower = workspace.tool(words);
        CHECK(shallower.exit_code == (row["core_cycles"].is_null() ? 3 : 0));
        if (!row["core_cycles"].is_null())
            CHECK(total_cycles(shallower.out) >= row["core_cycles"].get<std::uint64_t>());
    }
}

TEST_CASE("Depths and kinds of sizing.json give its cycles, by the rules of every generation") {
    Workspace const workspace;
    for (std::string const rules : {"spec", "vivado_hls", "vitis_hls"}) {
        CAPTURE(rules);
        std::string const setting = "accelerator.fifo_rules=" + rules;
        require_done(workspace.size({"--within", "1", "--out", "sizes", "--points", "0", "--set", setting}));
        Json const sizing = workspace.json("sizes/sizing.json");
        for (std::string const which : {"unbounded", "configured", "answer"}) {
            CAPTURE(which);
            Words words{"whatif", "events", "--full", "--set", setting};
            for (auto const& [fifo, depth] : sizing[which]["depths"].items()) {
                std::string const key = "accelerator.fifos." + fifo;
                words.insert(words.end(), {"--set", key + ".depth=" + depth.dump()});
                words.insert(words.end(), {"--set", key + ".kind=" + sizing[which]["kinds"][fifo].get<std::string>()});
            }
            CommandResult const replayed = workspace.tool(words);
            require_done(replayed);
            CHECK(total_cycles(replayed.out) == sizing[which]["total_cycles"].get<std::uint64_t>());
        }
        CHECK(sizing["unbounded"]["kinds"]["sample_vertex"] == "memory");  // though it is shallow
        CHECK_THAT(workspace.text("sizes/depths.yaml"),
                   Contains(rules == "vivado_hls" ? "kind: " : "fifo_rules: \"" + rules + '"'));
    }
}

TEST_CASE("The files of size-fifos agree, and are the same on any number of threads") {
    Workspace const workspace;
    require_done(workspace.size({"--within", "5", "--out", "one", "-j", "1", "--points", "4"}));
    require_done(workspace.size({"--within", "5", "--out", "three", "-j", "3", "--points", "4"}));
    for (std::string const file : {"/sizing.json", "/pareto.csv", "/depths.yaml"})
        CHECK(workspace.text("one" + file) == workspace.text("three" + file));
    Json const sizing = workspace.json("one/sizing.json");
    std::vector<std::string> const rows = lines_of(workspace.text("one/pareto.csv"));
    REQUIRE(rows.size() == sizing["front"].size() + 1);
    CHECK_THAT(rows[0], Contains("cost_luts,luts,ramb36,total_cycles,milliseconds,proven,sample_vertex,"));
    for (std::size_t i = 0; i < sizing["front"].size(); ++i)
        CHECK_THAT(rows[i + 1], Contains("," + sizing["front"][i]["total_cycles"].dump() + ","));
    require_done(workspace.size({"--within", "9", "--out", "one", "--points", "0"}));  // an older one is replaced
    CHECK(workspace.json("one/sizing.json")["front"].empty());
}

TEST_CASE("size-fifos keeps the kinds of a configuration, and weighs block RAM as it is told") {
    Workspace const workspace;
    require_done(
        workspace.size({"--within", "0", "--out", "a", "--points", "0", "--set",
                        "accelerator.fifos.command.kind=shift_register", "--set", "accelerator.raster_cores=1"}));
    Json const a = workspace.json("a/sizing.json");
    CHECK(a["raster_cores"] == 1);
    CHECK(a["fifos"][6]["fifo"] == "command");
    CHECK(a["fifos"][6]["kind"] == "shift_register");
    require_done(workspace.size({"--within", "0", "--out", "b", "--points", "0", "--ramb36-luts", "20"}));
    Json const b = workspace.json("b/sizing.json");
    CHECK(b["luts_per_ramb36"] == 20);
    CHECK(b["answer"]["ramb36"].get<double>() > 0);
    require_done(workspace.size({"--within", "0", "--out", "c", "--points", "0", "--ramb36-luts", "1000000"}));
    CHECK(workspace.json("c/sizing.json")["answer"]["ramb36"] == 0);
}

TEST_CASE("size-fifos leaves out the FIFOs that a flow does not have") {
    Workspace const workspace;
    require_done(workspace.tool({"run", "config.yaml", "--events", "grip_events", "--set", "accelerator.flow=fpga_grip",
                                 "--set", "accelerator.window=24", "--set", "workload.samples.count=2"}));
    CommandResult const result =
        workspace.tool({"size-fifos", "grip_events", "--within", "5", "--out", "sizes", "--points", "2"});
    require_done(result);
    check_bad_input(workspace.size({"--within", "nan"}), {"--within", "expected a number from 0"});
    CHECK_THAT(result.out, !Contains("edge_token") && !Contains("edge_map"));
    Json const sizing = workspace.json("sizes/sizing.json");
    CHECK(sizing["fifos"].size() == 12);
    CHECK_THAT(workspace.text("sizes/pareto.csv"), !Contains("edge_token"));
    CHECK(workspace.cycles_of_depths() == sizing["answer"]["total_cycles"].get<std::uint64_t>());
}

TEST_CASE("size-fifos refuses what is no good with one line, and leaves nothing") {
    Workspace const workspace;
    check_bad_input(workspace.size({}), {"--within"});
    check_bad_input(workspace.size({"--within", "-1"}), {"--within"});
    check_bad_input(workspace.size({"--within", "much"}), {"--within"});
    check_bad_input(workspace.size({"--within", "1", "--ramb36-luts", "0"}), {"--ramb36-luts"});
    check_bad_input(workspace.size({"--within", "1", "-j", "0"}), {"--jobs"});
    check_bad_input(workspace.size({"--within", "1", "--out", "out", "--set", "accelerator.window=30"}),
                    {"accelerator.window", "use faster-sim run"});
    check_bad_input(workspace.size({"--within", "1", "--out", "out", "--set", "accelerator.fifos.comand.kind=memory"}),
                    {"command"});
    CHECK_FALSE(workspace.has("out"));
    workspace.folder().write("file", "text");
    check_bad_input(workspace.size({"--within", "1", "--out", "file"}), {"file"});
    check_bad_input(workspace.tool({"size-fifos", "config.yaml", "--within", "1"}), {"is no event file"});
    check_bad_input(workspace.tool({"size-fifos", "missing", "--within", "1"}), {"missing"});
    check_bad_input(workspace.tool({"size-fifo"}), {"did you mean size-fifos"});
}

TEST_CASE("The help of size-fifos tells its options") {
    Workspace const workspace;
    CommandResult const result = workspace.tool({"size-fifos", "--help"});
    require_done(result);
    for (std::string const option : {"--within", "--out", "--ramb36-luts", "--points", "--jobs", "--set", "EVENTS"})
        CHECK_THAT(result.out, Contains(option));
}

}  // namespace size_fifos_test
