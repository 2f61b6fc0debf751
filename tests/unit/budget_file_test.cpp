#include "dataflow/tools/budgets/budget_file.hpp"

#include <catch2/catch.hpp>

#include "dataflow/tools/budgets/baseline_text.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace budget_file_test {

using namespace dataflow::budgets;
using Catch::Matchers::Contains;
using faster::test::input_error_text;
using faster::test::TempFolder;

std::string const head = "format: faster-budget\nversion: 1\nconfiguration: ../design.yaml\n";
std::string const hash = "fnv1a64:0123456789abcdef";
std::string const baseline = "baseline:\n  date: 2026-01-02\n  reason: \"first run\"\n  configuration: " + hash +
                             "\n"
                             "  accelerator: {accelerator.raster_cores: 1}\n"
                             "  figures:\n    total_cycles: 4111\n    fifos.vertex: {depth: 2, full_stall_cycles: 7}\n";

/// Four lines stand before those of `limits`, which are indented already.
std::string with_limits(std::string const& limits) { return head + "limits:\n" + limits + baseline; }

Budget read(std::string const& text, BaselineNeed need = BaselineNeed::required) {
    TempFolder const folder;
    return read_budget(folder.write("b.yaml", text), need);
}

/// The message for a file, from "b.yaml:" on.
std::string fault(std::string const& text) {
    TempFolder const folder;
    auto const file = folder.write("b.yaml", text);
    std::string const message = input_error_text([&] { read_budget(file); });
    std::size_t const place = message.find("b.yaml");
    return place == std::string::npos ? message : message.substr(place);
}

TEST_CASE("A budget file is read as it is written") {
    Budget const budget = read(head +
                               "trace: ../traces/empty\ntime_limit_s: 2.5\n"
                               "set: {accelerator.raster_cores: 3, workload.pose.translation_m: [0, 0, 1]}\n"
                               "limits:\n"
                               "  total_cycles: {min: 5, max: 1.5 ms}\n"
                               "  fifos.*.max_occupancy: {exact: 2}\n"
                               "  fifos.vertex.full_stall_cycles: {within: {of: baseline, percent: 2.5}}\n"
                               "  milliseconds: {max: 1.5}\n" +
                               baseline);
    CHECK(budget.configuration == "../design.yaml");
    CHECK(budget.trace == "../traces/empty");
    CHECK(budget.time_limit_s == 2.5);
    CHECK(budget.overrides ==
          std::vector<std::string>{"accelerator.raster_cores=3", "workload.pose.translation_m=[0, 0, 1]"});
    REQUIRE(budget.limits.size() == 4);
    CHECK(budget.limits[0].line == 8);
    CHECK(budget.limits[0].min->value == 5);
    CHECK(budget.limits[0].max->kind == Quantity::Kind::microseconds);
    CHECK(budget.limits[0].max->value == 1500);
    CHECK(budget.limits[1].exact->value == 2);
    CHECK(budget.limits[2].needs_baseline());
    CHECK(budget.limits[2].percent == 2.5);
    CHECK(budget.limits[3].figure == "total_cycles");
    CHECK(budget.limits[3].max->value == 1500);
    REQUIRE(budget.baseline);
    CHECK(budget.baseline->reason == "first run");
    CHECK(budget.baseline->accelerator == std::vector<Setting>{{"accelerator.raster_cores", "1"}});
    CHECK(budget.baseline->figures.find("total_cycles") == 4111);
    CHECK(budget.baseline->figures.find("fifos.vertex.full_stall_cycles") == 7);
}

TEST_CASE("A malformed budget is refused with file and line") {
    struct Case {
        std::string text;
        std::string expected;
    };
    std::vector<Case> const cases{
        {with_limits("  total_cycle: {max: 5}\n"),
         "b.yaml:5: limits.total_cycle: unknown figure, did you mean total_cycles?"},
        {with_limits("  fifos.vertx.max_occupancy: {max: 5}\n"),
         "b.yaml:5: limits.fifos.vertx.max_occupancy: unknown figure, did you mean fifos.vertex.max_occupancy?"},
        {with_limits("  fifos.*.max_ocupancy: {max: 5}\n"),
         "b.yaml:5: limits.fifos.*.max_ocupancy: matches no figure, did you mean fifos.*.max_occupancy?"},
        {with_limits("  samples.3.latency_cycle: {max: 5}\n"), "did you mean samples.3.latency_cycles?"},
        {with_limits("  fifos.x*.max_occupancy: {max: 5}\n"),
         "b.yaml:5: limits.fifos.x*.max_occupancy: matches no figure"},
        {with_limits("  cores.x.fifos.vertex.depth: {max: 5}\n"), "unknown figure"},
        {with_limits("  total_cycles: {min: 6, max: 5}\n"),
         "b.yaml:5: limits.total_cycles: contradictory limits: min 6 is above max 5"},
        {with_limits("  total_cycles: {min: 2 ms, max: 500 us}\n"),
         "contradictory limits: min 2 ms is above max 500 us"},
        {with_limits("  total_cycles: {exact: 6, max: 7}\n"), "b.yaml:5: limits.total_cycles: contradictory limits"},
        {with_limits("  total_cycles: {within: {of: 6, percent: 1}, min: 7}\n"), "contradictory limits"},
        {with_limits("  total_cycles: {max: 5 s}\n"),
         "b.yaml:5: limits.total_cycles.max = 5 s, expected a whole number"},
        {with_limits("  total_cycles: {max: 5ms}\n"), "limits.total_cycles.max = 5ms, expected"},
        {with_limits("  total_cycles: {max: 5 MS}\n"), "expected"},
        {with_limits("  total_cycles: {max: 1.5}\n"),
         "b.yaml:5: limits.total_cycles.max = 1.5, expected a whole number"},
        {with_limits("  total_cycles: {max: -1}\n"), "limits.total_cycles.max = -1, expected"},
        {with_limits("  milliseconds: {max: 5 cycles}\n"),
         "b.yaml:5: limits.milliseconds.max = 5 cycles, expected milliseconds"},
        {with_limits("  fifos.vertex.max_occupancy: {max: 5 us}\n"),
         "b.yaml:5: limits.fifos.vertex.max_occupancy.max = 5 us, expected a number without a unit of time"},
        {with_limits("  fifos.*.*: {max: 5 us}\n"), "expected a number without a unit of time"},
        {with_limits("  total_cycles: {maximum: 5}\n"), "b.yaml:5: limits.total_cycles.maximum: unknown limit"},
        {with_limits("  total_cycles: {max: 5, slack: -1}\n"),
         "b.yaml:5: limits.total_cycles.slack = -1, expected a number from 0 to 100"},
        {with_limits("  total_cycles: {exact: 5, slack: 1}\n"), "slack is of min or max"},
        {with_limits("  total_cycles: 5\n"), "b.yaml:5: limits.total_cycles = 5, expected a map"},
        {with_limits("  total_cycles: {}\n"), "expected a map"},
        {with_limits("  total_cycles: {within: {of: 5}}\n"), "b.yaml:5: limits.total_cycles.within: expected both"},
        {with_limits("  total_cycles: {within: {of: 5, percent: 101}}\n"), "expected a number from 0 to 100"},
        {with_limits("  total_cycles: {max: 5}\n  total_cycles: {max: 6}\n"),
         "b.yaml:6: limits.total_cycles: stands twice"},
        {with_limits("  samples.*.inlier: {exact: baseline}\n"),
         "b.yaml:5: limits.samples.*.inlier: no such figure in the baseline"},
        {with_limits(""), "b.yaml:4: limits = nothing, expected a map"},
        {head + "limits:\n  total_cycles: {max: 5}\n", "b.yaml:1: baseline: missing, expected one"},
        {head + baseline, "b.yaml:1: limits: missing"},
        {head + "limit: {total_cycles: {max: 5}}\n" + baseline, "limit: unknown key"},
        {head + "limits:\n  total_cycle: {max: 5}\n", "b.yaml:5: limits.total_cycle: unknown figure"},
        {"format: faster-trace\n" + with_limits("  total_cycles: {max: 5}\n").substr(22),
         "b.yaml:1: format = faster-trace"},
        {with_limits("  total_cycles: {max: 5}\n") + "limit: 3\n", "limit: unknown key"},
        {with_limits("  total_cycles: {max: 5}\n") + "set: {accelerator.raster_core: 3}\n",
         "b.yaml:14: set.accelerator.raster_core=3: unknown key"},
        {with_limits("  total_cycles: {max: 5}\n") + "set:\n  accelerator.window: 0\n",
         "b.yaml:15: set.accelerator.window=0: expected an integer"},
        {with_limits("  total_cycles: {max: 5}\n") + "time_limit_s: 0\n", "time_limit_s = 0, expected seconds"},
        {head + "limits: {total_cycles: {max: 5}}\nbaseline: {date: 2026-01-02, reason: y, configuration: " + hash +
             "}\n",
         "b.yaml:5: baseline: no key figures"},
        {head + "limits: {total_cycles: {max: 5}}\nbaseline: {date: 2026-01-02, reason: y, configuration: " + hash +
             ", figures: {a: b}}\n",
         "b.yaml:5: baseline.figures.a = b, expected a whole number"},
        {head + "limits: {total_cycles: {max: 5}}\nbaseline: {date: 2026-02-29}\n",
         "b.yaml:5: baseline.date = 2026-02-29, expected a date, YYYY-MM-DD"},
        {head + "limits: {total_cycles: {max: 5}}\nbaseline: {date: 2028-02-29, configuration: fnv:0}\n",
         "b.yaml:5: baseline.configuration = fnv:0, expected fnv1a64: and 16 hexadecimal digits"},
        {with_limits("  total_cycles: {max: 9007199254740992}\n"), "expected a whole number up to 9007199254740991"},
        {"- 3\n", "b.yaml:1: a list of 1, expected a budget"},
        {"a: [\n", "expected well-formed YAML"},
    };
    for (Case const& one : cases) {
        CAPTURE(one.text);
        CHECK_THAT(fault(one.text), Contains(one.expected));
    }
    CHECK_THAT(input_error_text([] { read_budget("nowhere.yaml"); }), Contains("nowhere.yaml: no such file"));
}

TEST_CASE("A budget without a baseline is fine where one is about to be written") {
    CHECK_FALSE(read(head + "limits: {total_cycles: {exact: baseline}}\n", BaselineNeed::optional).baseline);
}

TEST_CASE("A baseline reads back as it was written") {
    Baseline written{"2026-03-04",
                     "a \"quoted\" reason: # 5 \\ \n two lines",
                     "fnv1a64:000000000000001f",
                     {{"accelerator.raster_cores", "2"}, {"accelerator.fifos.vertex.kind", "memory"}},
                     {}};
    written.figures.set("total_cycles", 12);
    written.figures.set("loops.rasterizer.scan.ii", 1);
    written.figures.set("loops.rasterizer.scan.depth", 8);
    written.figures.set("loops.inlier_unit.sweep.ii", 3);
    Budget const budget = read(head + "limits: {total_cycles: {max: 20}}\n" + baseline_block(written));
    CHECK(is_same_run(*budget.baseline, written));
    CHECK(budget.baseline->reason == written.reason);
    CHECK(budget.baseline->date == written.date);
}

}  // namespace budget_file_test
