#include "dataflow/tools/compare/compare.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "dataflow/tools/compare/comparison_report.hpp"
#include "faster/dataflow_names.hpp"

namespace compare_test {

using namespace dataflow::runs;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using faster::Cycles;
using faster::FifoRow;
using faster::LoopRow;
using faster::SampleStatistics;

ModuleRecord module_of(std::uint64_t core, Cycles busy, Cycles idle) {
    return {core, "rasterizer", {{"busy_cycles", busy}, {"idle_cycles", idle}}};
}

FifoRow fifo_of(std::uint64_t core, Cycles full_stall, std::uint64_t occupancy) {
    FifoRow fifo;
    fifo.core = core;
    fifo.fifo = "command";
    fifo.kind_name = "shift_register";
    fifo.depth = 2;
    fifo.full_stall_cycles = full_stall;
    fifo.max_occupancy = occupancy;
    return fifo;
}

LoopRow loop_of(std::uint64_t core, Cycles ii, std::uint64_t iterations, Cycles port_conflict) {
    LoopRow loop;
    loop.core = core;
    loop.module = "inlier_unit";
    loop.loop = "sweep";
    loop.ii = ii;
    loop.iterations = iterations;
    loop.port_conflict_cycles = port_conflict;
    return loop;
}

SampleStatistics sample_of(Cycles latency, std::uint64_t inliers) {
    SampleStatistics sample;
    sample.start_cycle = 7;
    sample.end_cycle = 6 + latency;
    sample.counters = {0, 0, inliers, 0, 0};
    return sample;
}

/// Two cores, three samples.
RunRecord small_run() {
    RunRecord run;
    run.folder = "out/a";
    run.total_cycles = 1000;
    run.milliseconds = 0.005;
    run.raster_cores = 2;
    run.configuration = {{"simulation.engine", "\"lockstep\""}, {"accelerator.clock_mhz", "200.0"}};
    run.modules = {module_of(0, 600, 400), module_of(1, 500, 500)};
    run.fifos = {fifo_of(0, 30, 1), fifo_of(1, 20, 2)};
    run.loops = {loop_of(0, 3, 100, 10), loop_of(1, 3, 100, 10)};
    run.samples = {sample_of(500, 10), sample_of(300, 20), sample_of(400, 30)};
    return run;
}

std::vector<Change> changes_of(Comparison const& comparison, std::string const& list) {
    auto const found = std::find_if(comparison.figures.begin(), comparison.figures.end(),
                                    [&list](ChangeList const& l) { return l.name == list; });
    REQUIRE(found != comparison.figures.end());
    return found->changes;
}

std::size_t all_changes(Comparison const& comparison) {
    std::size_t count = 0;
    for (ChangeList const& list : comparison.figures)
        count += list.changes.size();
    return count;
}

/// "item figure a b difference" for each change, as compact as tables in a test want to be.
std::vector<std::string> words_of(std::vector<Change> const& changes) {
    auto const text = [](std::optional<std::uint64_t> value) { return value ? std::to_string(*value) : "-"; };
    std::vector<std::string> words;
    words.reserve(changes.size());
    for (Change const& c : changes)
        words.push_back(c.item + " " + c.figure + " " + text(c.a) + " " + text(c.b) + " " +
                        std::to_string(c.difference()));
    return words;
}

using Words = std::vector<std::string>;

TEST_CASE("A run compared with itself is identical", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.folder = "out/b";
    Comparison const comparison = compare(a, b);
    CHECK(comparison.identical);
    CHECK(comparison.is_functionally_equal());
    CHECK(all_changes(comparison) == 0);
    CHECK(comparison_text(comparison, 10) ==
          "identical: configuration, results and cycles of out/a and out/b (3 samples, 1,000 cycles)\n");
}

TEST_CASE("Figures that only change places between cores are not identical, but equal in sum", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    std::swap(b.modules[0].classes, b.modules[1].classes);
    Comparison const comparison = compare(a, b);
    CHECK_FALSE(comparison.identical);
    CHECK(all_changes(comparison) == 0);
    CHECK_THAT(comparison_text(comparison, 10), Contains("Configuration: the same\n") &&
                                                    Contains("Results: the same in all 3 samples\n") &&
                                                    Contains("Figures: the same, summed over cores\n"));
}

TEST_CASE("Configuration keys that differ or that one run lacks are listed with both values", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.configuration = {{"accelerator.clock_mhz", "100.0"}, {"accelerator.new", "[1,2]"}};
    Comparison const comparison = compare(a, b);
    CHECK(comparison.keys == 3);
    CHECK_THAT(comparison_text(comparison, 10), Contains("Configuration: 3 of 3 keys differ\n"
                                                         "  simulation.engine: \"lockstep\" -> -\n"
                                                         "  accelerator.clock_mhz: 200.0 -> 100.0\n"
                                                         "  accelerator.new: - -> [1,2]\n"));
}

TEST_CASE("Module cycles are summed over cores, largest change first", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.modules = {module_of(0, 601, 400), module_of(1, 501, 450)};
    CHECK(words_of(changes_of(compare(a, b), "module_cycles")) ==
          Words{"rasterizer idle_cycles 900 850 -50", "rasterizer busy_cycles 1100 1102 2"});
}

TEST_CASE("A cycle class or module that one run does not know counts as 0", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.modules[0].classes.push_back({"nap_cycles", 5});
    b.modules[0].classes.push_back({"unused_cycles", 0});
    b.modules[1].module = "renamed";
    CHECK(words_of(changes_of(compare(a, b), "module_cycles")) ==
          Words{"rasterizer busy_cycles 1100 600 -500", "rasterizer idle_cycles 900 400 -500",
                "renamed busy_cycles - 500 500", "renamed idle_cycles - 500 500", "rasterizer nap_cycles - 5 5"});
}

TEST_CASE("FIFO stalls are summed, occupancy is the largest of any core, shapes are said when they change",
          "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.fifos = {fifo_of(0, 0, 9), fifo_of(1, 5, 3)};
    CHECK(compare(a, b).fifo_shapes.empty());
    for (FifoRow& fifo : b.fifos) {
        fifo.depth = 16;
        fifo.kind_name = "memory";
    }
    Comparison const comparison = compare(a, b);
    CHECK(words_of(changes_of(comparison, "fifo_stalls")) == Words{"command full_stall_cycles 50 5 -45"});
    CHECK(words_of(changes_of(comparison, "fifo_occupancies")) == Words{"command max_occupancy 2 9 7"});
    CHECK_THAT(comparison_text(comparison, 10), Contains("\nFIFOs: depth and kind\n"
                                                         "  command.depth: 2 -> 16\n"
                                                         "  command.kind: \"shift_register\" -> \"memory\"\n"));
}

TEST_CASE("Loops tell their interval, iterations and losses", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.loops = {loop_of(0, 1, 110, 0), loop_of(1, 1, 100, 0)};
    b.loops[1].recurrence_cycles = 3;
    Comparison const comparison = compare(a, b);
    CHECK(words_of(changes_of(comparison, "loop_intervals")) == Words{"inlier_unit.sweep ii 3 1 -2"});
    CHECK(words_of(changes_of(comparison, "loop_iterations")) == Words{"inlier_unit.sweep iterations 200 210 10"});
    CHECK(words_of(changes_of(comparison, "loop_losses")) ==
          Words{"inlier_unit.sweep port_conflict_cycles 20 0 -20", "inlier_unit.sweep recurrence_cycles 0 3 3"});
}

TEST_CASE("Sample latency is compared by its median and maximum", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.samples = {sample_of(100, 10), sample_of(300, 20), sample_of(350, 30), sample_of(900, 40)};
    CHECK(words_of(changes_of(compare(a, b), "sample_latencies")) ==
          Words{"max latency_cycles 500 900 400", "median latency_cycles 400 300 -100"});
    b.samples.clear();
    CHECK(words_of(changes_of(compare(a, b), "sample_latencies")) ==
          Words{"max latency_cycles 500 - -500", "median latency_cycles 400 - -400"});
}

TEST_CASE("A sample that scores differently is told with the counters that differ", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.samples[1].counters = {0, 0, 21, 4, 0};
    Comparison const comparison = compare(a, b);
    CHECK_FALSE(comparison.is_functionally_equal());
    CHECK_THAT(comparison_text(comparison, 10),
               Contains("\nResults: 1 of 3 samples differ\n  sample 1: inlier 20 -> 21, valid_edge 0 -> 4\n"));
}

TEST_CASE("Every counter of a sample counts", "[compare]") {
    for (std::size_t counter = 0; counter < 5; ++counter) {
        RunRecord b = small_run();
        b.samples[2].counters.at(counter) += 1;
        Comparison const comparison = compare(small_run(), b);
        CHECK_FALSE(comparison.is_functionally_equal());
        CHECK_THAT(comparison_text(comparison, 10), Contains("  sample 2: "));
    }
}

TEST_CASE("Runs with other samples or cores are compared as far as they go, with a note", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.samples.pop_back();
    b.raster_cores = 1;
    Comparison const comparison = compare(a, b);
    CHECK(comparison.compared_samples == 2);
    CHECK(comparison.samples.empty());
    CHECK_FALSE(comparison.is_functionally_equal());
    CHECK_THAT(comparison_text(comparison, 10),
               StartsWith("A  out/a (3 samples, 2 raster cores)\n"
                          "B  out/a (2 samples, 1 raster cores)\n"
                          "note: A has 2 raster cores, B 1; figures are sums over all of them\n"
                          "note: A has 3 samples, B 2; results are compared for those that both have\n"));
}

TEST_CASE("The headline has cycles and milliseconds with difference and percent", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.total_cycles = 1250;
    b.milliseconds = 0.00625;
    CHECK_THAT(comparison_text(compare(a, b), 10), Contains("\nTotal\n"
                                                            "              A      B  difference  percent\n"
                                                            "  cycles  1,000  1,250        +250   +25.00\n"
                                                            "  ms      0.005  0.006      +0.001   +25.00\n"));
    RunRecord none = a;
    none.total_cycles = 0;
    CHECK_THAT(comparison_text(compare(none, a), 10), Contains("  cycles      0  1,000      +1,000        -\n"));
}

TEST_CASE("Each list ends after the top rows and counts the others", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.modules = {module_of(0, 650, 350), module_of(1, 500, 501)};
    b.samples = {sample_of(500, 11), sample_of(300, 21), sample_of(400, 31)};
    std::string const one = comparison_text(compare(a, b), 1);
    CHECK_THAT(one,
               Contains("  rasterizer busy_cycles  1,100  1,150         +50    +4.55\n  ... and 1 more (--top)\n"));
    CHECK_THAT(one, Contains("  sample 0: inlier 10 -> 11\n  ... and 2 more (--top)\n"));
    CHECK_THAT(one, !Contains("sample 1") && !Contains("idle_cycles"));
    CHECK_THAT(comparison_text(compare(a, b), 3), !Contains("more (--top)"));
}

TEST_CASE("The JSON file has the whole comparison", "[compare]") {
    RunRecord const a = small_run();
    RunRecord b = a;
    b.folder = "out/\xff";  // not UTF-8: a folder may be called anything
    b.total_cycles = 900;
    b.configuration[0].value = "\"decoupled\"";
    b.configuration.pop_back();
    b.fifos[0].depth = 16;
    b.loops[0].recurrence_cycles = 3;
    b.samples[1].counters[2] = 21;
    auto const json = nlohmann::json::parse(comparison_json(compare(a, b)));
    CHECK(json.at("format") == "faster-comparison");
    CHECK(json.at("version") == 1);
    CHECK(json.at("identical") == false);
    CHECK(json.at("a") == nlohmann::json({{"folder", "out/a"}, {"samples", 3}, {"raster_cores", 2}}));
    CHECK(json.at("configuration").dump() == R"([{"a":"lockstep","b":"decoupled","key":"simulation.engine"},)"
                                             R"({"a":200.0,"b":null,"key":"accelerator.clock_mhz"}])");
    CHECK(json.at("total_cycles").dump() == R"({"a":1000,"b":900,"difference":-100,"percent":-10.0})");
    CHECK(json.at("milliseconds").at("difference") == 0.0);
    CHECK(json.at("results").at("equal") == false);
    CHECK(json.at("results").at("compared_samples") == 3);
    CHECK(json.at("results").at("different_samples").size() == 1);
    CHECK(json.at("results").at("different_samples")[0].at("sample") == 1);
    CHECK(json.at("results").at("different_samples")[0].at("b").at("inlier") == 21);
    CHECK(json.at("fifo_shapes").dump() == R"([{"a":2,"b":16,"key":"command.depth"}])");
    CHECK(json.at("figures").at("loop_losses").dump() ==
          R"([{"a":0,"b":3,"difference":3,"figure":"recurrence_cycles","item":"inlier_unit.sweep","percent":null}])");
    CHECK(json.at("figures").at("module_cycles").empty());
}

}  // namespace compare_test
