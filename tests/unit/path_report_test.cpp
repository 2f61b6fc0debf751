#include <catch2/catch.hpp>

#include "dataflow/tools/report/critical_path_report.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"
#include "faster/dataflow_names.hpp"
#include "support/example_run.hpp"
#include "support/tool_output.hpp"

namespace dataflow::report::path_report_test {

using faster::test::example_run;
using faster::test::lines_of;

TEST_CASE("The critical path is told with module, loop, cause and what is to blame", "[report]") {
    std::string const text = critical_path_text(example_run());
    CHECK(text.find("Critical path of core 1, the last to end: how its 1,000,000 cycles came about") !=
          std::string::npos);
    CHECK(text.find("inlier_unit.sweep           port_conflict depth_buffer         300,000   30.00") !=
          std::string::npos);
    CHECK(text.find("rasterizer                  setup                               90,000    9.00") !=
          std::string::npos);
    CHECK(text.find("inlier_unit.fragment        read_latency command                10,000    1.00") !=
          std::string::npos);
    CHECK(critical_path_text(RunStatistics{}).empty());
}

TEST_CASE("A long critical path is cut, and the rest counted", "[report]") {
    RunStatistics run = example_run();
    PathRow row;
    row.cycles = 3;
    run.critical_path->rows.resize(12, row);
    run.critical_path->rows.resize(15, row);
    std::string const text = critical_path_text(run);
    CHECK(text.find("(3 more in summary.json)") != std::string::npos);
    CHECK(text.substr(text.size() - 3) == " 9\n");
}

TEST_CASE("The critical path as JSON keeps every row", "[report]") {
    Json const path = critical_path_json(example_run());
    CHECK(path["core"] == 1);
    REQUIRE(path["rows"].size() == 4);
    CHECK(path["rows"][1] == Json{{"module", "inlier_unit"},
                                  {"loop", "sweep"},
                                  {"cause", "port_conflict"},
                                  {"item", "depth_buffer"},
                                  {"cycles", 300000},
                                  {"crossings", 0}});
    CHECK(path["rows"][2]["loop"] == "");
    CHECK(path["rows"][3]["item"] == "command");
    CHECK(path["rows"][3]["crossings"] == 10000);
}

TEST_CASE("Sensitivities are told with the one first that moves the total most, either way", "[report]") {
    std::string const text = sensitivities_text(example_run());
    std::size_t const setup = text.find("accelerator.loops.rasterizer.setup.depth");
    std::size_t const command = text.find("accelerator.fifos.command.depth");
    REQUIRE(setup != std::string::npos);
    CHECK(setup < command);
    CHECK(text.find("     -7,500 (-0.75 %)       +7,500 (+0.75 %)\n") != std::string::npos);
    CHECK(text.find("deadlock         -500 (-0.05 %)\n") != std::string::npos);
    CHECK(text.find("accelerator.fifos.vertex.depth") == std::string::npos);  // changes nothing
    CHECK(text.find("1 key changes nothing") != std::string::npos);
    CHECK(sensitivities_text(RunStatistics{}).empty());

    RunStatistics run = example_run();
    run.sensitivities.front().up.total_cycles = run.total_cycles + 8000;
    std::string const costly = sensitivities_text(run);
    CHECK(costly.find("command.depth") < costly.find("setup.depth"));
}

TEST_CASE("Target and dependence of a loop that do the same are one row, and a long key moves no column", "[report]") {
    RunStatistics run = example_run();
    SensitivityStep step;
    step.valid = true;
    step.total_cycles = run.total_cycles + 10;
    std::string const loop = "accelerator.loops.a_module_of_a_long_name.scan.";
    for (char const* const key : {"ii", "recurrence_ii"})
        run.sensitivities.push_back({loop + key, 1, SensitivityStep{}, step});
    std::string const text = sensitivities_text(run);
    CHECK(text.find("scan.ii, recurrence_ii  ") != std::string::npos);
    CHECK(text.find("scan.recurrence_ii") == std::string::npos);
    std::vector<std::string> const lines = lines_of(text);
    for (std::size_t i = 3; lines[i].find("accelerator.") != std::string::npos; ++i)
        CHECK(lines[i].size() == lines[2].size());
    run.sensitivities.back().up.total_cycles += 1;
    CHECK(sensitivities_text(run).find("scan.recurrence_ii") != std::string::npos);
}

TEST_CASE("sensitivities.csv has a row per step, with its outcome", "[report]") {
    CHECK(sensitivities_csv(example_run()) ==
          "key,value,changed_value,outcome,total_cycles,change_cycles\n"
          "accelerator.fifos.command.depth,2,1,deadlock,,\n"
          "accelerator.fifos.command.depth,2,3,finished,999500,-500\n"
          "accelerator.fifos.vertex.depth,1,0,invalid,,\n"
          "accelerator.fifos.vertex.depth,1,2,finished,1000000,0\n"
          "accelerator.loops.rasterizer.setup.depth,12,11,finished,992500,-7500\n"
          "accelerator.loops.rasterizer.setup.depth,12,13,finished,1007500,7500\n");
    Json const rows = sensitivities_json(example_run());
    CHECK(rows[0]["down"] == Json{{"outcome", "deadlock"}});
    CHECK(rows[2]["up"] == Json{{"outcome", "finished"}, {"total_cycles", 1007500}, {"change_cycles", 7500}});
}

}  // namespace dataflow::report::path_report_test
