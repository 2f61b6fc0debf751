// Functions over hls::stream (examples/hls_*): their cycles against those of the designs by hand, of closed forms and
// of published ones; and the schedule of a synthesis report.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace hls_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

fs::path const examples = fs::path(FASTER_SOURCE_DIR) / "examples";
fs::path const published = examples / "hls_published";
fs::path const reports = fs::path(FASTER_SOURCE_DIR) / "tests" / "data" / "schedule";

Words with_settings(Words words, Words const& settings) {
    for (std::string const& setting : settings)
        words.insert(words.end(), {"--set", setting});
    return words;
}

/// Total cycles of a run, or "deadlock at" and what else it says of one.
std::string outcome(std::string const& binary, Words const& arguments) {
    TempFolder const folder;
    Words all = arguments;
    all.insert(all.end(), {"--out", "out"});
    CommandResult const result = run_command(binary, all, folder.path());
    if (result.exit_code == 3)
        return result.err.substr(0, result.err.find('\n'));
    INFO(result.err);
    REQUIRE(result.exit_code == 0);
    return std::to_string(
               nlohmann::json::parse(content_of(folder / "out/summary.json")).at("total_cycles").get<int>()) +
           "\n" + content_of(folder / "out/samples.csv");
}
std::string cycles(std::string const& binary, fs::path const& configuration, Words const& settings = {}) {
    std::string const all = outcome(binary, with_settings({"run", configuration.string()}, settings));
    return all.substr(0, all.find('\n'));
}

TEST_CASE("Functions over streams take the cycles that are published for their designs", "[examples]") {
    for (std::string const engine : {"decoupled", "lockstep"}) {
        std::string const set = "simulation.engine=" + engine;
        CAPTURE(engine);
        CHECK(cycles(HLS_CYCLIC_BINARY, published / "cyclic.yaml", {set}) == "4053");
        CHECK_THAT(outcome(HLS_SHARING_BINARY, with_settings({"run", (published / "sharing.yaml").string()}, {set})),
                   StartsWith("4062\n") && Contains(",1351,674,1366878,684447\n"));
        CHECK_THAT(outcome(HLS_TIMER_BINARY, with_settings({"run", (published / "timer.yaml").string()}, {set})),
                   StartsWith("16201\n") && Contains(",6075\n"));
        CHECK_THAT(outcome(HLS_BRANCHES_BINARY, with_settings({"run", (published / "branches.yaml").string()}, {set})),
                   StartsWith("989\n") && Contains(",15519,614\n"));
        CHECK(cycles(HLS_FIFO_PAIR_BINARY, published / "fifo_16.yaml", {set}) == "52");  // latency 51
        CHECK(cycles(HLS_FIFO_PAIR_BINARY, published / "fifo_16.yaml", {set, "workload.samples=16"}) == "832");
        CHECK(cycles(HLS_FIFO_PAIR_BINARY, published / "fifo_multiply.yaml", {set}) == "84");
        CHECK(cycles(HLS_FIFO_PAIR_BINARY, published / "fifo_multiply.yaml",
                     {set, "workload.samples=16", "accelerator.fifos.word.depth=2"}) == "1344");
        CHECK(cycles(HLS_DOT_PRODUCT_BINARY, published / "dot_product.yaml", {set}) == "10100");
        CHECK(outcome(HLS_DROPPING_BINARY, {"run", (published / "dropping.yaml").string(), "--set", set}) ==
              outcome(DROPPING_BINARY, {"run", (examples / "published" / "dropping.yaml").string(), "--set", set}));
    }
}

TEST_CASE("The same design by functions and by hand takes the same cycles, whatever the keys", "[examples]") {
    unsigned const seed = 540;
    CAPTURE(seed);
    std::mt19937 random(seed);
    auto const one_of = [&random](Words const& values) { return values[random() % values.size()]; };
    for (int trial = 0; trial < 8; ++trial) {
        Words const pipeline{"accelerator.loops.scaler.scale.ii=" + one_of({"1", "2", "3"}),
                             "accelerator.fifos.number.depth=" + one_of({"1", "2", "9"}),
                             "accelerator.fifos.number.read_stage=" + one_of({"0", "1", "2"}),
                             "workload.numbers=" + one_of({"1", "40"}), "workload.samples=" + one_of({"1", "3"})};
        Words const cyclic{"accelerator.loops.controller.exchange.ii=" + one_of({"1", "2", "3"}),
                           "accelerator.loops.processor.double.ii=" + one_of({"1", "2", "3"}),
                           "accelerator.fifos.response.read_stage=" + one_of({"1", "2"}),
                           "accelerator.fifos.request.kind=" + one_of({"auto", "memory"}), "workload.messages=30"};
        CAPTURE(trial, pipeline, cyclic);
        fs::path const by_hand = examples / "pipeline" / "pipeline.yaml";
        std::string const same = outcome(PIPELINE_BINARY, with_settings({"run", by_hand.string()}, pipeline));
        std::string const circle =
            outcome(CYCLIC_BINARY, with_settings({"run", (examples / "cyclic" / "cyclic.yaml").string()}, cyclic));
        for (std::string const engine : {"decoupled", "lockstep"}) {
            Words const in{"--set", "simulation.engine=" + engine};
            auto const of = [&](fs::path const& file, Words const& settings) {
                Words words = with_settings({"run", file.string()}, settings);
                words.insert(words.end(), in.begin(), in.end());
                return words;
            };
            CHECK(outcome(HLS_PIPELINE_BINARY, of(examples / "hls_pipeline" / "hls_pipeline.yaml", pipeline)) == same);
            CHECK(outcome(HLS_CYCLIC_BINARY, of(published / "cyclic.yaml", cyclic)) == circle);
        }
    }
}

TEST_CASE("Functions that do not wait find what modules by hand do, whatever the keys", "[examples]") {
    unsigned const seed = 541;
    CAPTURE(seed);
    std::mt19937 random(seed);
    auto const one_of = [&random](Words const& values) { return values[random() % values.size()]; };
    std::string const configuration = (examples / "arbiter" / "arbiter.yaml").string();
    for (int trial = 0; trial < 16; ++trial) {
        Words const settings{"workload.messages=" + one_of({"1", "2", "37"}),
                             "workload.samples=" + one_of({"1", "3"}),
                             "accelerator.arbiter.round_robin=" + one_of({"0", "1"}),
                             "accelerator.loops.first.produce.ii=" + one_of({"1", "2", "3"}),
                             "accelerator.loops.second.produce.ii=" + one_of({"1", "2", "5"}),
                             "accelerator.loops.arbiter.grant.ii=" + one_of({"1", "2"}),
                             "accelerator.loops.arbiter.grant.depth=" + one_of({"2", "4"}),
                             "accelerator.loops.consumer.consume.ii=" + one_of({"1", "3"}),
                             "accelerator.fifos.second_message.depth=" + one_of({"1", "2", "40"}),
                             "simulation.engine=" + one_of({"decoupled", "lockstep"})};
        CAPTURE(settings);
        CHECK(outcome(HLS_ARBITER_BINARY, with_settings({"run", configuration}, settings)) ==
              outcome(ARBITER_BINARY, with_settings({"run", configuration}, settings)));
    }
}

/// Number i is written in cycle 4 i + 2. The first is seen in 3, by a state of its own, and read in 4; each other is
/// read in the cycle in which it is seen, 4 i + 3. The last condition is asked in the cycle behind that, by an
/// iteration of two stages.
TEST_CASE("The condition of a loop belongs to its iterations", "[examples]") {
    TempFolder const folder;
    std::ofstream(folder / "empty.yaml") << "{}\n";
    for (int const numbers : {2, 10, 33})
        for (std::string const engine : {"decoupled", "lockstep"})
            CHECK(cycles(HLS_POLLER_BINARY, folder / "empty.yaml",
                         {"workload.numbers=" + std::to_string(numbers), "simulation.engine=" + engine}) ==
                  std::to_string(4 * numbers + 2));
    CommandResult const refused =
        run_command(HLS_POLLER_BINARY, {"run", "empty.yaml", "--set", "workload.asks_size=1"}, folder.path());
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("stream number is asked for its size(), which hardware does not count"));
}

/// A question is written, looked for once outside the loop, in 8 iterations without and in one with an answer in its
/// condition, the first of which has asked before it began, and read: 12 cycles, behind the one of the start.
TEST_CASE("A loop may only ask, and tokens may be left where the design says so", "[examples]") {
    TempFolder const folder;
    std::ofstream(folder / "empty.yaml") << "{}\n";
    for (std::string const engine : {"decoupled", "lockstep"}) {
        Words const words{"run", "empty.yaml", "--out", "out", "--set", "simulation.engine=" + engine};
        CommandResult const result = run_command(HLS_ASKER_BINARY, words, folder.path());
        CHECK(result.exit_code == 0);
        CHECK_THAT(content_of(folder / "out/samples.csv"), Contains(",121,80\n"));
        CHECK_THAT(result.err, Contains("tokens are left at the end of the run, unread: word of core 0"));
    }
}

TEST_CASE("Results are those of all functions, whoever returns first", "[examples]") {
    TempFolder const folder;
    std::ofstream(folder / "empty.yaml") << "{}\n";
    for (std::string const engine : {"decoupled", "lockstep"})
        for (std::string const calls : {"overlapped", "in_turn"}) {
            std::string const samples = calls == "in_turn" ? "3" : "1";
            require_done(run_command(HLS_LATE_BINARY,
                                     {"run", "empty.yaml", "--out", "out", "--set", "simulation.engine=" + engine,
                                      "--set", "accelerator.calls=" + calls, "--set", "workload.samples=" + samples},
                                     folder.path()));
            std::string const table = content_of(folder / "out/samples.csv");
            CHECK(std::count(table.begin(), table.end(), '\n') == (calls == "in_turn" ? 4 : 2));
            for (std::size_t row = table.find('\n'); row + 1 < table.size(); row = table.find('\n', row + 1))
                CHECK(table.substr(table.find('\n', row + 1) - 3, 3) == ",45");
            fs::remove_all(folder / "out");
        }
}

/// What the design of examples/hls_mistakes.cpp says of a run in which it makes `mistake`.
std::string said_of(std::string const& mistake, Words const& settings) {
    TempFolder const folder;
    setenv("MISTAKE", mistake.c_str(), 1);
    CommandResult const result =
        run_command(HLS_MISTAKES_BINARY, with_settings({"run", "/dev/null", "--set", "workload.samples=6"}, settings),
                    folder.path());
    unsetenv("MISTAKE");
    return std::to_string(result.exit_code) + ": " + result.out + result.err;
}

TEST_CASE("A mistake of functions is one line, in both engines and with any number of cores", "[examples]") {
    std::string const engine = GENERATE("lockstep", "decoupled");
    std::string const cores = GENERATE("1", "3");
    CAPTURE(engine, cores);
    auto const says = [&](std::string const& mistake) {
        return said_of(mistake, {"simulation.engine=" + engine, "accelerator.cores=" + cores});
    };
    std::string const who = "2: hls_mistakes: ";
    CHECK_THAT(says("none"), Contains(cores == "1" ? "total  98 cycles" : "total  34 cycles"));
    CHECK(says("early token") == who +
                                     "stream number holds a token before a process has begun, expected only "
                                     "processes to write it\n");
    CHECK(says("constructor") ==
          who + "the constructor of design hls_mistakes has thrown: no such table, expected one that returns\n");
    CHECK(says("results") == who + "results() of the design has thrown: no such sum, expected its counters\n");
    CHECK(says("shared stream") == who +
                                       "stream shared is none of the design's, expected streams between functions as "
                                       "members of the class that derives HlsDesign\n");
    CHECK(says("other's end") ==
          who + "process adder asks stream number by full(), expected only process sender to, which writes it\n");
    CHECK(says("loop in states") ==
          who +
              "process adder has a marked loop in its block of states pause, expected a block "
              "without one, { FASTER_STATES(pause, STATES); }\n");
    CHECK_THAT(says("late attempt"), Contains(who + "process sender accesses stream number by write_nb() or full()"));
    CHECK_THAT(says("too many"),
               Contains("3: ") && Contains("deadlock at cycle " + std::string(cores == "1" ? "104" : "35")) &&
                   Contains("adder (loop add, iteration ") && Contains("tests/examples/hls_mistakes.cpp:") &&
                   Contains(") waits for sender to write to number"));
}

TEST_CASE("What-if, sizes and waveforms know a design of functions", "[examples]") {
    TempFolder const folder;
    fs::path const configuration = examples / "hls_pipeline" / "hls_pipeline.yaml";
    auto const done = [&](Words const& words) {
        CommandResult result = run_command(HLS_PIPELINE_BINARY, words, folder.path());
        require_done(result);
        return result.out;
    };
    done({"run", configuration.string(), "--events", "events", "--vcd", "run.vcd"});
    CHECK_THAT(done({"whatif", "events", "--set", "accelerator.loops.scaler.scale.ii=1"}), Contains("4,021"));
    CHECK_THAT(done({"size-fifos", "events", "--within", "0"}), Contains("Proven"));
    CHECK_THAT(content_of(folder / "run.vcd"), Contains("fifo_number") && Contains("$var wire 32"));
}

TEST_CASE("C simulation is the functions as plain C++", "[examples]") {
    TempFolder const folder;
    CommandResult const result = run_command(HLS_TEST_BENCH_BINARY, {}, folder.path());
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.out, Contains("sum 1498500"));
    fs::path const configuration = examples / "hls_pipeline" / "hls_pipeline.yaml";
    CHECK_THAT(outcome(HLS_PIPELINE_BINARY, {"run", configuration.string()}), Contains(",1498500"));
}

/// All that a design takes besides its functions.
TEST_CASE("A design of functions takes at most 30 lines", "[examples]") {
    auto const lines = lines_of(content_of(examples / "hls_pipeline" / "hls_pipeline.cpp"));
    CHECK(lines.size() <= 30);
}

TEST_CASE("A deadlock of functions is reported alike in both engines", "[examples]") {
    Words const settings{"accelerator.fifos.response.read_stage=1", "accelerator.loops.controller.exchange.depth=2"};
    std::string const first =
        outcome(HLS_CYCLIC_BINARY, with_settings({"run", (published / "cyclic.yaml").string()}, settings));
    CHECK_THAT(first, Contains("deadlock"));
    Words lockstep = settings;
    lockstep.emplace_back("simulation.engine=lockstep");
    CHECK(outcome(HLS_CYCLIC_BINARY, with_settings({"run", (published / "cyclic.yaml").string()}, lockstep)) == first);
}

CommandResult schedule(std::string const& binary, Words const& arguments, TempFolder const& folder) {
    Words all{"schedule"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_command(binary, all, folder.path());
}

TEST_CASE("A schedule takes states and depths from a report, and says what they change", "[examples]") {
    TempFolder const folder;
    std::ofstream(folder / "start.yaml") << "accelerator: {fifos: {word: {depth: 2, read_stage: 1}}}\n";
    CommandResult const result =
        schedule(HLS_FIFO_PAIR_BINARY,
                 {(reports / "fifo_pair.xml").string(), "--config", "start.yaml", "--out", "scheduled.yaml"}, folder);
    require_done(result);
    CHECK_THAT(result.out, Contains("accelerator.loops.consumer.receive.states        2          5"));
    CHECK_THAT(result.out, Contains("checker.check of the report: no loop of the design"));
    CHECK_THAT(result.out, Contains("scheduled  84"));
    CHECK(cycles(HLS_FIFO_PAIR_BINARY, folder / "scheduled.yaml") == "84");
    CHECK_THAT(result.out, Contains("        2         16  word"));
}

TEST_CASE("Reports of a published design schedule it by a map", "[examples]") {
    TempFolder const folder;
    Words words;
    for (std::string const name : {"reader", "multiplier", "tree", "accumulator"})
        words.push_back((reports / ("vitis_2020_" + name + ".xml")).string());
    words.insert(words.end(), {"--map", (reports / "dot_product.map.yaml").string(), "--config",
                               (published / "dot_product.yaml").string()});
    CommandResult const result = schedule(HLS_DOT_PRODUCT_BINARY, words, folder);
    require_done(result);
    CHECK_THAT(result.out, Contains("scheduled  10,100") && Contains("accelerator.loops.tree.add.depth"));
    CHECK_THAT(result.out, Contains("writer.answer of the design: no loop of the report"));
}

TEST_CASE("Reports of other versions are read, and what has no counterpart is named", "[examples]") {
    TempFolder const folder;
    std::map<std::string, std::string> const expected{
        {"vivado_2018.xml", "Filter2D.loop_width of the report"},
        {"vitis_2021.xml", "matrixmul_Pipeline_Row_Col.Row_Col of the report"},
        {"vitis_2023.xml", "jpegls_encode_hls.VITIS_LOOP_243_4 of the report"}};
    for (auto const& [file, line] : expected) {
        CAPTURE(file);
        CommandResult const result = schedule(HLS_FIFO_PAIR_BINARY, {(reports / file).string()}, folder);
        require_done(result);
        CHECK_THAT(result.out, Contains(line) && Contains("# Schedule of HLS"));
    }
    std::ofstream(folder / "map.yaml")
        << "loops: {producer.send: Filter2D.loop_height, consumer.receive: Filter2D.Loop1}\n";
    CommandResult const result =
        schedule(HLS_FIFO_PAIR_BINARY, {(reports / "vivado_2018.xml").string(), "--map", "map.yaml"}, folder);
    require_done(result);
    CHECK_THAT(result.out, Contains("states: 1929") && Contains("states: 1 "));
}

TEST_CASE("A broken report, or map, is one line with file, line, what is there and what is expected", "[examples]") {
    TempFolder const folder;
    auto const complaint = [&](std::string const& report, std::string const& map) {
        std::ofstream(folder / "r.xml") << report;
        std::ofstream(folder / "map.yaml") << map;
        CommandResult const result = schedule(HLS_FIFO_PAIR_BINARY, {"r.xml", "--map", "map.yaml"}, folder);
        CHECK(result.exit_code == 2);
        CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
        return result.err;
    };
    std::string const good = content_of(reports / "fifo_pair.xml");
    auto const with = [&good](std::string const& from, std::string const& to) {
        std::string text = good;
        return text.replace(text.find(from), from.size(), to);
    };
    CHECK_THAT(complaint("<profile>\n<a></profile>", ""), Contains("r.xml:2: no XML") && Contains("expected"));
    CHECK_THAT(complaint("<html></html>", ""), Contains("root element html, expected profile"));
    CHECK_THAT(complaint(with("<IterationLatency>3", "<IterationLatency>three"), ""),
               Contains("r.xml:14: IterationLatency of send = three, expected a whole number"));
    CHECK_THAT(complaint("<profile/>", ""), Contains("no loop, expected"));
    CHECK_THAT(complaint(good, "loops: {producer.sent: a.b}"), Contains("did you mean producer.send?"));
    CHECK_THAT(complaint(good, "loop: {}"), Contains("section loop, expected loops or fifos"));
    CHECK_THAT(complaint(good, "loops:\n  producer.send: a.b\n  producer.send: c.d\n"),
               Contains("map.yaml:3: loops.producer.send: stands twice, expected once"));
    CHECK_THAT(complaint(good, "loops: {}\nloops: {producer.send: a.b}\n"),
               Contains("map.yaml:2: loops: stands twice, expected once"));
}

/// A report of pipelined loops.
struct Pipelined {
    std::string module, name;
    int ii, depth;
};
std::string report_of(std::vector<Pipelined> const& loops, std::string const& fifos = "") {
    std::string text = "<profile>\n<ReportVersion><Version>2022.2</Version></ReportVersion>\n<ModuleInformation>\n";
    for (Pipelined const& loop : loops)
        text += "<Module><Name>" + loop.module + "</Name><PerformanceEstimates><SummaryOfLoopLatency><" + loop.name +
                "><TripCount>30</TripCount><PipelineII>" + std::to_string(loop.ii) + "</PipelineII><PipelineDepth>" +
                std::to_string(loop.depth) + "</PipelineDepth></" + loop.name +
                "></SummaryOfLoopLatency></PerformanceEstimates></Module>\n";
    return text + "</ModuleInformation>\n" + fifos + "</profile>\n";
}
std::string fifo_node(std::string const& name, std::string const& depth) {
    return "<BindNode OPTYPE=\"fifo\" VARIABLE=\"" + name + "\" DEPTH=\"" + depth + "\"/>\n";
}
CommandResult schedule_loads(TempFolder const& folder, std::string const& report, Words const& more = {}) {
    std::ofstream(folder / "r.xml") << report;
    std::ofstream(folder / "empty.yaml") << "{}\n";
    Words words{"r.xml"};
    words.insert(words.end(), more.begin(), more.end());
    return schedule(HLS_LOADS_BINARY, words, folder);
}

TEST_CASE("A module of a report belongs to the process with the longest name that it begins with", "[examples]") {
    TempFolder const folder;
    CommandResult const result = schedule_loads(folder, report_of({{"load_w_Pipeline_1", "L", 4, 9}}));
    require_done(result);
    CHECK_THAT(result.out, Contains("accelerator.loops.load_w.fetch.ii") && !Contains("accelerator.loops.load.") &&
                               Contains("load.fetch of the design: no loop of the report"));
}

/// What it finds is needed before the next iteration reads.
TEST_CASE("A scheduled loop attempts to write before its next iteration reads", "[examples]") {
    TempFolder const folder;
    for (auto const& [ii, depth, stage] : {std::array{2, 5, 1}, {4, 3, 2}}) {
        CommandResult const result = schedule_loads(folder, report_of({{"sum", "add", ii, depth}}),
                                                    {"--config", "empty.yaml", "--out", "scheduled.yaml"});
        require_done(result);
        std::string const row = "accelerator.fifos.sums.write_latency        1          " + std::to_string(stage);
        CHECK_THAT(result.out, Contains(row));
        cycles(HLS_LOADS_BINARY, folder / "scheduled.yaml");
    }
    CommandResult const refused = schedule_loads(
        folder, report_of({{"sum", "add", 2, 5}}),
        {"--config", "empty.yaml", "--set", "accelerator.fifos.weight.read_stage=1", "--out", "refused.yaml"});
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("the scheduled run cannot be done: loop sum.add reads weight in stage 1"));
    CHECK(!fs::exists(folder / "refused.yaml"));
}

TEST_CASE("What a report says twice and differently is not chosen from", "[examples]") {
    TempFolder const folder;
    Pipelined const add{"sum", "add", 2, 5};
    std::ofstream(folder / "map.yaml") << "loops: {sink.poll: sum.add}\n";
    CommandResult const same = schedule_loads(folder, report_of({add, add}), {"--map", "map.yaml"});
    require_done(same);
    CHECK_THAT(same.out, Contains("accelerator.loops.sink.poll.depth"));
    std::string const differ = report_of({add, {"sum", "add", 3, 5}}, fifo_node("sums", "4") + fifo_node("sums", "8"));
    CommandResult const twice = schedule_loads(folder, differ);
    require_done(twice);
    CHECK_THAT(twice.out,
               Contains("sum.add of the design: several loops of the report with one name and other figures") &&
                   Contains("sums of the report, of depth 8: another FIFO of the report has its name") &&
                   !Contains("accelerator.fifos.sums.depth"));
    CHECK_THAT(schedule_loads(folder, differ, {"--map", "map.yaml"}).err,
               Contains("map.yaml: loops: sum.add is several loops of the report, expected one"));
}

TEST_CASE("A loop of the report is one without trip count, too, and with two trip counts", "[examples]") {
    TempFolder const folder;
    Pipelined const add{"sum", "add", 2, 5};
    std::string const trips = "<TripCount>30</TripCount>";
    std::string twice = report_of({add, add});
    twice.replace(twice.rfind(trips), trips.size(), "<TripCount>20</TripCount>");
    std::string without = report_of({add});
    without.erase(without.find(trips), trips.size());
    for (std::string const& report : {twice, without}) {
        CommandResult const result = schedule_loads(folder, report);
        require_done(result);
        CHECK_THAT(result.out, Contains("accelerator.loops.sum.add.depth"));
    }
}

TEST_CASE("Of an interval and a depth, a report may know one", "[examples]") {
    TempFolder const folder;
    std::string const ii = "<PipelineII>4</PipelineII>";
    std::string const depth = "<PipelineDepth>5</PipelineDepth>";
    for (bool const has_ii : {true, false}) {
        std::string report = report_of({{"sum", "add", 4, 5}});
        std::string const& missing = has_ii ? depth : ii;
        report.erase(report.find(missing), missing.size());
        CommandResult const result = schedule_loads(folder, report);
        require_done(result);
        std::string const loop = "accelerator.loops.sum.add.";
        CHECK_THAT(result.out,
                   Contains(loop + (has_ii ? "ii" : "depth")) && !Contains(loop + (has_ii ? "depth" : "ii")));
        CHECK_THAT(result.out, Contains(std::string("sum.add of the report: no ") + (has_ii ? "depth" : "interval")));
    }
}

TEST_CASE("A figure that no key can have is told by its place in the report", "[examples]") {
    TempFolder const folder;
    Pipelined const add{"sum", "add", 2, 5};
    CHECK_THAT(schedule_loads(folder, report_of({add, {"load", "fetch", 1, 5'000'000}})).err,
               Contains("r.xml:5: PipelineDepth of load.fetch = 5000000, expected 1 to 1000000"));
    CHECK_THAT(schedule_loads(folder, report_of({add}, fifo_node("sums", "9000000"))).err,
               Contains("r.xml:6: DEPTH of sums = 9000000, expected 1 to 1048576"));
    CHECK_THAT(schedule_loads(folder, report_of({add}, fifo_node("sums", "0"))).out,
               Contains("sums of the report: no depth that it knows"));
    std::ofstream(folder / "map.yaml") << "fifos: {sums: sum_stream}\n";
    CHECK_THAT(
        schedule_loads(folder, report_of({add}, fifo_node("sums_stream", "4")), {"--map", "map.yaml"}).err,
        Contains("map.yaml: fifos: sum_stream is not there, expected a FIFO of the report, did you mean sums_stream?"));
}

TEST_CASE("What is wrong with a function that runs is one line with its process", "[examples]") {
    TempFolder const folder;
    std::ofstream(folder / "empty.yaml") << "{}\n";
    for (std::string const binary : {HLS_LOADS_BINARY, HLS_WAITING_LOADS_BINARY})
        for (std::string const engine : {"decoupled", "lockstep"}) {
            auto const refused = [&](std::string const& mistake) {
                CommandResult const result =
                    run_command(binary,
                                with_settings({"run", "empty.yaml"},
                                              {"workload.mistake=" + mistake, "simulation.engine=" + engine}),
                                folder.path());
                CHECK(result.exit_code == 2);
                CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
                return result.err;
            };
            CAPTURE(binary, engine);
            CHECK_THAT(refused("1"), Contains("process load has thrown: no row 3"));
            CHECK_THAT(refused("2"), Contains("process load has thrown something that is no std::exception"));
            CHECK_THAT(refused("3"), Contains("process sum reads stream last in its loop add, which it does not with "
                                              "the defaults of the design's numbers"));
            CHECK_THAT(refused("5"), Contains("process load accesses stream pair by write_nb() or full()") &&
                                         Contains(", which it does not with the defaults of the design's numbers"));
            CHECK_THAT(refused("6"), Contains("stream last holds a token before a process has begun"));
            CHECK_THAT(refused("7"), Contains("the constructor of design loads has thrown: no numbers"));
            CHECK_THAT(refused("8"), Contains("results() of the design has thrown: no total"));
        }
    CommandResult const endless =
        run_command(HLS_WAITING_LOADS_BINARY, {"run", "empty.yaml", "--set", "workload.mistake=4"}, folder.path());
    CHECK(endless.exit_code == 2);
    CHECK_THAT(endless.err, Contains("process load has begun more than") && Contains("iterations of its loop fetch"));
}

/// Whatever bytes there are, the answer is a table or a line.
TEST_CASE("A damaged report does no harm", "[examples]") {
    unsigned const seed = 541;
    CAPTURE(seed);
    std::mt19937 random(seed);
    TempFolder const folder;
    for (int trial = 0; trial < 40; ++trial) {
        std::string text = content_of(reports / (trial % 2 == 0 ? "fifo_pair.xml" : "vitis_2023.xml"));
        for (int change = 0; change < 3; ++change) {
            std::size_t const at = random() % text.size();
            if (random() % 2 == 0)
                text.erase(at, random() % 40);
            else
                text[at] = static_cast<char>(random());
        }
        std::ofstream(folder / "r.xml", std::ios::binary) << text;
        CommandResult const result = schedule(HLS_FIFO_PAIR_BINARY, {"r.xml"}, folder);
        CAPTURE(trial, text, result.err);
        CHECK((result.exit_code == 0 || result.exit_code == 2));
        CHECK_THAT(result.err, !Contains("unexpected"));
    }
}

}  // namespace hls_test
