#include <catch2/catch.hpp>
#include <utility>

#include "dataflow/base/program_name.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/budgets/check_files.hpp"
#include "dataflow/tools/budgets/check_result.hpp"
#include "dataflow/tools/budgets/check_text.hpp"
#include "dataflow/tools/budgets/evaluate.hpp"
#include "dataflow/tools/budgets/figure_pattern.hpp"
#include "dataflow/tools/budgets/figures.hpp"
#include "dataflow/tools/budgets/starting_budget.hpp"
#include "faster/dataflow_names.hpp"
#include "support/counters.hpp"
#include "support/idle_run.hpp"
#include "support/input_error_text.hpp"
#include "support/raster_machine.hpp"

namespace budget_evaluation_test {

using namespace dataflow::budgets;
using Catch::Matchers::Contains;
using faster::test::input_error_text;

Quantity count(double value) { return {Quantity::Kind::count, value, std::to_string(static_cast<int>(value))}; }
Quantity microseconds(double value) { return {Quantity::Kind::microseconds, value, std::to_string(value) + " us"}; }
Quantity const as_before{Quantity::Kind::baseline, 0, "baseline"};

Limit limit_on(std::string const& figure, int line = 5) {
    Limit limit;
    limit.figure = figure;
    limit.line = line;
    return limit;
}
Limit exactly(std::string const& figure, Quantity const& value, int line = 5) {
    Limit limit = limit_on(figure, line);
    limit.exact = value;
    return limit;
}
Limit at_most(std::string const& figure, Quantity const& value, int line = 5) {
    Limit limit = limit_on(figure, line);
    limit.max = value;
    return limit;
}
Limit at_least(std::string const& figure, Quantity const& value, int line = 5) {
    Limit limit = limit_on(figure, line);
    limit.min = value;
    return limit;
}

Figures figures(std::vector<Figure> const& list) {
    Figures result;
    for (Figure const& figure : list)
        result.set(figure.name, figure.value);
    return result;
}

Measurement measured(std::vector<Figure> const& list) {
    Measurement measurement;
    measurement.figures = figures(list);
    return measurement;
}

Budget budget_with(std::vector<Limit> const& limits) {
    Budget budget;
    budget.file = "b.yaml";
    budget.limits = limits;
    return budget;
}

std::vector<Verdict> verdicts(std::vector<Limit> const& limits, std::vector<Figure> const& run,
                              std::vector<Figure> const& before = {}) {
    Baseline baseline;
    baseline.figures = figures(before);
    return evaluate(budget_with(limits), measured(run), baseline);
}

bool keeps(Limit const& limit, std::uint64_t value) { return !has_breach(verdicts({limit}, {{limit.figure, value}})); }

TEST_CASE("A limit holds up to its bound and not a cycle further") {
    CHECK(keeps(at_most("total_cycles", count(10)), 10));
    CHECK_FALSE(keeps(at_most("total_cycles", count(10)), 11));
    CHECK(keeps(at_least("total_cycles", count(10)), 10));
    CHECK_FALSE(keeps(at_least("total_cycles", count(10)), 9));
    CHECK(keeps(exactly("total_cycles", count(10)), 10));
    CHECK_FALSE(keeps(exactly("total_cycles", count(10)), 9));
    CHECK_FALSE(keeps(exactly("total_cycles", count(10)), 11));
    Limit within = limit_on("total_cycles");
    within.of = count(250);
    within.percent = 1;  // 247.5 .. 252.5
    CHECK_FALSE(keeps(within, 247));
    CHECK(keeps(within, 248));
    CHECK(keeps(within, 252));
    CHECK_FALSE(keeps(within, 253));
    within.percent = 2;  // 245 .. 255, whole numbers
    CHECK(keeps(within, 245));
    CHECK(keeps(within, 255));
    CHECK_FALSE(keeps(within, 256));
}

TEST_CASE("Slack is what may come on top of a limit, in percent of it") {
    Limit most = at_most("total_cycles", count(1000));
    most.slack = 2;
    CHECK(keeps(most, 1020));
    CHECK_FALSE(keeps(most, 1021));
    Limit least = at_least("total_cycles", count(1000));
    least.slack = 0.5;
    CHECK(keeps(least, 995));
    CHECK_FALSE(keeps(least, 994));
    CHECK(most.text() == "max 1000, 2 % slack");
}

TEST_CASE("A time counts in cycles of the clock, rounded to what still keeps it") {
    CHECK(keeps(at_most("total_cycles", microseconds(20.555)), 4111));  // at 200 MHz
    CHECK_FALSE(keeps(at_most("total_cycles", microseconds(20.555)), 4112));
    CHECK(keeps(at_most("total_cycles", microseconds(0.0149)), 2));  // 2.98 cycles
    CHECK_FALSE(keeps(at_most("total_cycles", microseconds(0.0149)), 3));
    CHECK(keeps(at_least("total_cycles", microseconds(0.0149)), 3));
    CHECK_FALSE(keeps(at_least("total_cycles", microseconds(0.0149)), 2));
    CHECK(keeps(exactly("total_cycles", microseconds(20.555)), 4111));
    CHECK_THAT(input_error_text([] { keeps(exactly("total_cycles", microseconds(0.0149)), 3); }),
               Contains("b.yaml:5: limits.total_cycles: exact = ") && Contains("expected a whole number of cycles"));
}

TEST_CASE("A wildcard limits every match, and shows the tightest") {
    auto const judged =
        verdicts({at_most("fifos.*.max_occupancy", count(3))}, {{"fifos.area.max_occupancy", 1},
                                                                {"fifos.vertex.max_occupancy", 5},
                                                                {"fifos.vertex.depth", 9},
                                                                {"fifos.result.max_occupancy", 4},
                                                                {"cores.0.fifos.area.max_occupancy", 7}});
    REQUIRE(judged.size() == 1);
    CHECK(judged[0].matches == 3);
    CHECK(judged[0].tightest.figure == "fifos.vertex.max_occupancy");
    CHECK(judged[0].tightest.margin == -2);
    CHECK(judged[0].tightest.percent == Approx(-200.0 / 3));
    CHECK(judged[0].breaches.size() == 2);
    CHECK(breach_text(judged[0].limit, judged[0].breaches[1]) ==
          "fifos.result.max_occupancy = 4, expected max 3: 1 above");
}

TEST_CASE("A limit that matches nothing of the run is an error, and so are other figures than the baseline's") {
    auto const fault = [](Limit const& limit, std::vector<Figure> const& run, std::vector<Figure> const& before) {
        return input_error_text([&] { verdicts({limit}, run, before); });
    };
    CHECK_THAT(fault(at_most("samples.*.inlier", count(3), 7), {{"samples", 0}, {"raster_cores", 2}}, {}),
               Contains("b.yaml:7: limits.samples.*.inlier: matches no figure of the run") &&
                   Contains("0 samples and 2 raster cores"));
    CHECK_THAT(fault(exactly("samples.*.inlier", as_before), {{"samples.0.inlier", 1}, {"samples.1.inlier", 1}},
                     {{"samples.0.inlier", 1}}),
               Contains("no samples.1.inlier in the baseline"));
    CHECK_THAT(fault(exactly("samples.*.inlier", as_before), {{"samples.0.inlier", 1}},
                     {{"samples.0.inlier", 1}, {"samples.1.inlier", 1}}),
               Contains("the baseline has samples.1.inlier, the run has not"));
    CHECK_FALSE(has_breach(
        verdicts({exactly("samples.*.inlier", as_before)}, {{"samples.0.inlier", 1}}, {{"samples.0.inlier", 1}})));
}

TEST_CASE("Limits of two lines that no figure can keep are an error") {
    std::string const text = input_error_text([] {
        verdicts({at_most("*_cycles", microseconds(0.05), 4), at_least("total_cycles", count(11), 6)},
                 {{"total_cycles", 5}});
    });
    CHECK_THAT(text, Contains("b.yaml:6: limits.total_cycles: contradictory limits") &&
                         Contains("at least 11 (line 6) and at most 10 (line 4)"));
    CHECK_FALSE(has_breach(
        verdicts({at_most("*_cycles", count(10)), at_least("total_cycles", count(10))}, {{"total_cycles", 10}})));
}

TEST_CASE("A name matches part by part") {
    CHECK(FigurePattern("fifos.*.depth").matches("fifos.vertex.depth"));
    CHECK_FALSE(FigurePattern("fifos.*").matches("fifos.vertex.depth"));
    CHECK_FALSE(FigurePattern("*").matches("fifos.vertex.depth"));
    CHECK(FigurePattern("fifos.fragment_*.*_stall_cycles").matches("fifos.fragment_index.full_stall_cycles"));
    CHECK_FALSE(FigurePattern("fifos.vertex.depth").matches("cores.0.fifos.vertex.depth"));
    CHECK(possible_names("samples.17.inlier").size() == 1);
    CHECK(possible_names("cores.*.loops.*.*.ii").size() == 13);
    CHECK(possible_names("samples.x.inlier").empty());
}

TEST_CASE("Figures of all cores are sums, of shapes and occupancies the largest") {
    faster::RunStatistics run = faster::testing::idle_run(faster::testing::raster_machine({}), 2);
    run.total_cycles = 100;
    run.samples.resize(1);
    run.samples[0].counters.resize(faster::testing::counter_names.size());
    run.samples[0].start_cycle = 5;
    run.samples[0].end_cycle = 14;
    for (std::size_t core = 0; core < 2; ++core) {
        auto& fifo = run.cores[core].fifos[3];
        fifo.depth = 2;
        fifo.max_occupancy = 1 + core;
        fifo.full_stall_cycles = 10 + core;
        run.cores[core].processes[2].cycles[0] = 20 + core;
        run.cores[core].processes[2].stalls[3] = 3;
        run.cores[core].loops[8].ii = 3;
        run.cores[core].loops[8].limited_by = "depth_buffer";
        run.cores[core].loops[8].port_conflict_cycles = 6;
    }
    Figures const found = run_figures(run);
    CHECK(found.find("total_cycles") == 100);
    CHECK(found.find("raster_cores") == 2);
    CHECK(found.find("fifos.vertex.depth") == 2);
    CHECK(found.find("fifos.vertex.max_occupancy") == 2);
    CHECK(found.find("fifos.vertex.full_stall_cycles") == 21);
    CHECK(found.find("cores.1.fifos.vertex.full_stall_cycles") == 11);
    CHECK(found.find("modules.rasterizer.busy_cycles") == 41);
    CHECK(found.find("modules.rasterizer.stalls.vertex") == 6);
    CHECK(found.find("loops.inlier_unit.sweep.ii") == 3);
    CHECK(found.find("brams.depth_buffer.port_conflict_cycles") == 12);
    CHECK(found.find("brams.depth_buffer.ports") == 2);
    CHECK(found.find("samples.0.latency_cycles") == 10);
}

TEST_CASE("A block RAM has the ports of all its banks, as in summary.json") {
    faster::AcceleratorConfig config;
    config.memory("depth_buffer").partition = {dataflow::PartitionType::cyclic, 2, 0};
    Figures const found = run_figures(faster::testing::idle_run(faster::testing::raster_machine(config), 1));
    CHECK(found.find("brams.depth_buffer.ports") == 8);
}

TEST_CASE("Times are for figures in cycles only") {
    for (char const* const name : {"total_cycles", "samples.0.start_cycle", "modules.rasterizer.stalls.vertex",
                                   "loops.rasterizer.scan.depth", "fifos.vertex.write_latency"})
        CHECK(is_in_cycles(name));
    for (char const* const name : {"samples", "fifos.vertex.depth", "fifos.vertex.writes", "samples.0.inlier",
                                   "loops.rasterizer.scan.iterations", "brams.edge_map.ports"})
        CHECK_FALSE(is_in_cycles(name));
}

TEST_CASE("What moved is told by kind, the largest first, settings with their defaults") {
    Baseline baseline;
    baseline.configuration = "a";
    baseline.accelerator = {{"accelerator.raster_cores", "2"}};
    baseline.figures = figures({{"total_cycles", 100},
                                {"modules.rasterizer.setup_cycles", 12},
                                {"modules.rasterizer.busy_cycles", 50},
                                {"modules.inlier_unit.empty_stall_cycles", 5},
                                {"fifos.vertex.depth", 2},
                                {"fifos.vertex.full_stall_cycles", 9},
                                {"samples.0.inlier", 4},
                                {"samples.0.end_cycle", 4}});
    Measurement run = measured({{"total_cycles", 101},
                                {"modules.rasterizer.setup_cycles", 13},
                                {"modules.rasterizer.busy_cycles", 40},
                                {"modules.inlier_unit.empty_stall_cycles", 6},
                                {"fifos.vertex.depth", 3},
                                {"fifos.vertex.full_stall_cycles", 2},
                                {"samples.0.inlier", 4},
                                {"samples.0.end_cycle", 5}});
    run.configuration = "b";
    run.accelerator = {{"accelerator.raster_cores", "2"}, {"accelerator.fifos.vertex.depth", "3"}};
    Explanation const explanation = explain(baseline, run);
    CHECK_FALSE(explanation.same_configuration);
    REQUIRE(explanation.settings.size() == 1);
    CHECK(explanation.settings[0].a == "2");
    CHECK(explanation.settings[0].b == "3");
    CHECK(explanation_text(explanation, 1) ==
          "    setting  accelerator.fifos.vertex.depth  2 -> 3\n"
          "    shape    fifos.vertex.depth  2 -> 3  +1 (+50.00 %)\n"
          "    work     modules.rasterizer.busy_cycles  50 -> 40  -10 (-20.00 %)\n"
          "             ... and 1 more\n"
          "    waiting  fifos.vertex.full_stall_cycles  9 -> 2  -7 (-77.78 %)\n"
          "             ... and 1 more\n");
    CHECK(explain(baseline,
                  [&] {
                      Measurement same = measured(baseline.figures.all());
                      same.configuration = "a";
                      same.accelerator = baseline.accelerator;
                      return same;
                  }())
              .is_empty());
}

TEST_CASE("A measurement survives the way from one process to another") {
    Measurement sent = measured({{"total_cycles", 18446744073709551615U}, {"samples.0.inlier", 0}});
    sent.kind = Measurement::Kind::deadlock;
    sent.message = "two\nlines and \"quotes\"";
    sent.clock_mhz = 156.25;
    sent.configuration = "fnv1a64:1";
    sent.accelerator = {{"accelerator.window", "32"}};
    Measurement const received = measurement_from_text(to_text(sent));
    CHECK(received.kind == sent.kind);
    CHECK(received.message == sent.message);
    CHECK(received.clock_mhz == sent.clock_mhz);
    CHECK(received.accelerator == sent.accelerator);
    CHECK(received.figures.find("total_cycles") == 18446744073709551615U);
    CHECK(received.figures.all().size() == 2);
    std::string const text = to_text(sent);
    CHECK_THROWS_AS(measurement_from_text(text.substr(0, text.size() / 2)), std::runtime_error);
}

TEST_CASE("The hash of a configuration is FNV-1a and does not know the engine") {
    using faster::ResolvedKey;
    // Published test vectors of FNV-1a 64 are for bare text; a key line is text like any other.
    CHECK(faster::configuration_hash({}) == "fnv1a64:cbf29ce484222325");
    std::vector<ResolvedKey> keys{{"accelerator.window", std::int64_t{32}, false}};
    std::string const small = faster::configuration_hash(keys);
    keys[0].value = std::int64_t{33};
    CHECK(faster::configuration_hash(keys) != small);
    keys[0].value = std::int64_t{32};
    keys.push_back({"simulation.engine", std::string("lockstep"), false});
    CHECK(faster::configuration_hash(keys) == small);
    std::uint64_t expected = 14695981039346656037U;
    for (char const letter : std::string("accelerator.window=32\n"))
        expected = (expected ^ static_cast<unsigned char>(letter)) * 1099511628211U;
    CHECK(std::stoull(small.substr(8), nullptr, 16) == expected);
}

TEST_CASE("JUnit and JSON say of each limit whether it is kept, whatever the texts hold") {
    CheckResult breached;
    breached.name = "a<b>&\"c\"";
    breached.file = "a.yaml";
    breached.status = CheckResult::Status::breached;
    breached.verdicts = verdicts({at_most("total_cycles", count(10)), at_most("samples", count(9))},
                                 {{"total_cycles", 12}, {"samples", 3}});
    breached.baseline_date = "2026-01-02";
    breached.baseline_reason = "why \x01";
    CheckResult crashed;
    crashed.name = "crash";
    crashed.status = CheckResult::Status::crashed;
    crashed.message = "signal 11";
    std::string const xml = junit_xml({breached, crashed});
    CHECK_THAT(xml, Contains("<testsuites name=\"faster-sim check\" tests=\"3\" failures=\"1\" errors=\"1\""));
    CHECK_THAT(xml,
               Contains("<testsuite name=\"a&lt;b&gt;&amp;&quot;c&quot;\" file=\"a.yaml\" tests=\"2\" failures=\"1\""));
    CHECK_THAT(xml, Contains("message=\"total_cycles = 12, expected max 10: 2 cycles above\""));
    CHECK_THAT(xml, Contains("name=\"samples: max 9\" time=\"0\"/>"));
    CHECK_THAT(xml, Contains("<error type=\"crashed\" message=\"signal 11\">"));
    CHECK_THAT(xml, Contains("why \\x01"));
    std::string const json = check_json({breached, crashed});
    CHECK_THAT(json,
               Contains("\"passed\": false") && Contains("\"margin\": -2") && Contains("\"status\": \"crashed\""));
    CHECK(totals_text({breached, crashed}) == "2 budgets: 1 breached, 1 crashed\n");
    std::string const name = std::exchange(dataflow::program_name(), "another");
    CHECK_THAT(junit_xml({crashed}), Contains("<testsuites name=\"another check\""));
    dataflow::program_name() = name;
}

TEST_CASE("A first budget leaves the slack that it names, and no more, to runs of any length") {
    for (std::uint64_t const cycles : {1U, 431U, 1999U, 2001U, 1234567U}) {
        CAPTURE(cycles);
        Measurement measurement;
        measurement.figures.set("total_cycles", cycles);
        std::string const text = starting_budget({}, measurement, {}, "2026-01-02");
        std::string const before = "total_cycles: {max: ";
        REQUIRE_THAT(text, Contains(before) && Contains(" us, slack: 2}"));
        double const max = std::stod(text.substr(text.find(before) + before.size())) * measurement.clock_mhz;
        CHECK(max >= Approx(static_cast<double>(cycles)).epsilon(1e-9));
        CHECK(max <= 1.001 * static_cast<double>(cycles));
    }
}

TEST_CASE("Settings of a first budget are in quotes where they would be read back as something else") {
    Budget budget;
    budget.overrides = {"workload.object=meshes/a #1.obj", "workload.trace=", "accelerator.raster_cores=2",
                        "workload.pose.translation_m=[0, 0, 1]"};
    Measurement measurement;
    measurement.figures.set("total_cycles", 1);
    measurement.accelerator = {{"accelerator.a", "x, y"}, {"accelerator.b", "}"}, {"accelerator.c", "touched"}};
    CHECK_THAT(starting_budget(budget, measurement, {}, "2026-01-02"),
               Contains("  workload.object: \"meshes/a #1.obj\"\n  workload.trace: \"\"\n"
                        "  accelerator.raster_cores: 2\n  workload.pose.translation_m: [0, 0, 1]\n") &&
                   Contains("  accelerator: {accelerator.a: \"x, y\", accelerator.b: \"}\", "
                            "accelerator.c: touched}\n"));
}

}  // namespace budget_evaluation_test
