// The designs of examples/: each by the commands that every design has, and its cycles against closed forms.
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace examples_test {

using namespace faster::test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::map<std::string, std::string> const binaries{{"pipeline", PIPELINE_BINARY},
                                                  {"cyclic", CYCLIC_BINARY},
                                                  {"convolution", CONVOLUTION_BINARY},
                                                  {"arbiter", ARBITER_BINARY},
                                                  {"memory", MEMORY_BINARY}};

/// One of the examples, with a folder for what it writes.
class Example {
  public:
    explicit Example(std::string name) : name_(std::move(name)) {}

    fs::path source(std::string const& file) const { return fs::path(FASTER_SOURCE_DIR) / "examples" / name_ / file; }
    fs::path configuration() const { return source(name_ + ".yaml"); }
    fs::path operator/(std::string const& file) const { return folder_ / file; }
    std::string text(std::string const& file) const { return content_of(folder_ / file); }

    CommandResult call(Words const& arguments) const {
        return run_command(binaries.at(name_), arguments, folder_.path());
    }
    CommandResult done(Words const& arguments) const {
        CommandResult result = call(arguments);
        require_done(result);
        return result;
    }
    CommandResult run(Words const& settings, Words const& more = {}) const {
        Words arguments{"run", configuration().string()};
        for (std::string const& setting : settings)
            arguments.insert(arguments.end(), {"--set", setting});
        arguments.insert(arguments.end(), more.begin(), more.end());
        return done(arguments);
    }
    /// Of a run with these settings; its files are in the folder `out`.
    std::uint64_t cycles(Words const& settings, std::string const& out = "out") const {
        run(settings, {"--out", out});
        return nlohmann::json::parse(text(out + "/summary.json")).at("total_cycles").get<std::uint64_t>();
    }
    std::string tables(std::string const& out) const {
        return text(out + "/samples.csv") + text(out + "/fifos.csv") + text(out + "/loops.csv");
    }

  private:
    std::string name_;
    TempFolder folder_;
};

Words const all_examples{"pipeline", "cyclic", "convolution", "memory"};

/// Timing keys that each example has, with values other than its configuration's.
Words timing_settings(std::string const& example) {
    if (example == "pipeline")
        return {"accelerator.loops.scaler.scale.ii=3", "accelerator.fifos.number.depth=5",
                "accelerator.fifos.number.read_stage=2", "accelerator.loops.writer.store.depth=9"};
    if (example == "cyclic")
        return {"accelerator.fifos.request.depth=4", "accelerator.fifos.response.kind=memory",
                "accelerator.loops.processor.double.ii=3"};
    if (example == "memory")
        return {"accelerator.memory.outstanding=1", "accelerator.memory.port_bytes=16",
                "accelerator.memory.model=ideal", "accelerator.fifos.loaded.depth=9",
                "accelerator.loops.storer.store.depth=7"};
    return {"accelerator.brams.line_buffer.ports=1", "accelerator.fifos.pixel.depth=7",
            "accelerator.loops.convolve.convolve.depth=11"};
}

TEST_CASE("Every example runs, and its engines agree", "[examples]") {
    for (std::string const& name : all_examples) {
        CAPTURE(name);
        Example const example(name);
        Words all = timing_settings(name);
        all.emplace_back("workload.samples=3");
        for (std::string const& setting : all) {
            CAPTURE(setting);
            Words settings{"workload.samples=3", "accelerator.cores=2", setting};
            example.cycles(settings, "decoupled");
            settings.emplace_back("simulation.engine=lockstep");
            example.cycles(settings, "lockstep");
            CHECK(example.tables("decoupled") == example.tables("lockstep"));
            CHECK(lines_of(example.text("lockstep/samples.csv")).size() == 4);
        }
    }
}

TEST_CASE("What-if answers what a run would", "[examples]") {
    for (std::string const& name : all_examples) {
        Example const example(name);
        example.run({}, {"--events", "events"});
        for (std::string const& setting : timing_settings(name)) {
            CAPTURE(name, setting);
            example.cycles({setting}, "run");
            example.done({"whatif", "events", "--set", setting, "--out", "whatif"});
            CHECK(example.tables("whatif") == example.tables("run"));
            fs::remove_all(example / "run");
            fs::remove_all(example / "whatif");
        }
    }
}

/// A key, and the values that chance may give it.
struct KeyRange {
    std::string key;
    Words values;
};

Words numbers(int first, int last) {
    Words all;
    for (int i = first; i <= last; ++i)
        all.push_back(std::to_string(i));
    return all;
}

std::vector<KeyRange> ranges_of(std::string const& example) {
    Words const kinds{"auto", "shift_register", "memory"};
    std::vector<KeyRange> ranges{{"fifo_rules", {"spec", "vivado_hls", "vitis_hls"}}};
    auto const add = [&ranges](std::string const& key, Words const& values) { ranges.push_back({key, values}); };
    auto const add_fifo = [&](std::string const& name, int deepest) {
        add("fifos." + name + ".depth", numbers(1, deepest));
        add("fifos." + name + ".kind", kinds);
    };
    if (example == "pipeline") {
        add_fifo("number", 40);
        add_fifo("product", 40);
        add("fifos.number.read_stage", numbers(0, 3));
        for (std::string const loop : {"reader.fetch", "scaler.scale", "writer.store"})
            add("loops." + loop + ".ii", numbers(1, 4));
        add("loops.writer.store.recurrence_ii", numbers(1, 4));
    } else if (example == "cyclic") {
        add_fifo("request", 4);
        add_fifo("response", 4);
        add("fifos.request.read_stage", numbers(0, 1));
        add("fifos.response.read_stage", numbers(0, 2));
        add("loops.controller.exchange.ii", numbers(1, 4));
        add("loops.processor.double.ii", numbers(1, 4));
        add("controller.entry_states", numbers(0, 3));
    } else if (example == "memory") {
        add_fifo("loaded", 40);
        add("loops.doubler.double.ii", numbers(1, 3));
        add("memory.burst_bytes", {"16", "64", "256"});
        add("memory.outstanding", numbers(1, 6));
        add("memory.request_cycles", numbers(0, 40));
        add("memory.dram_gb_per_s", {"0.5", "2", "19.2"});
    } else {
        add_fifo("pixel", 9);
        add_fifo("sum", 9);
        add("brams.line_buffer.ports", numbers(1, 4));
        add("loops.convolve.convolve.ii", numbers(1, 4));
        add("loops.convolve.convolve.depth", numbers(6, 12));
    }
    return ranges;
}

/// What a run says of its cycles, or of a deadlock.
std::string outcome(Example const& example, Words const& arguments, std::string const& out) {
    Words all = arguments;
    all.insert(all.end(), {"--out", out});
    CommandResult const result = example.call(all);
    std::string const text =
        result.exit_code == 0 ? example.tables(out) : result.err.substr(0, result.err.find("\nwritten"));
    fs::remove_all(example / out);
    return std::to_string(result.exit_code) + "\n" + text;
}

TEST_CASE("Every example does the same in both engines and as a what-if, whatever its keys", "[examples]") {
    unsigned const seed = 40;
    CAPTURE(seed);
    std::mt19937 random(seed);
    unsigned stuck = 0;
    for (std::string const& name : all_examples) {
        Example const example(name);
        Words const workload{"--set", "workload.samples=2"};
        example.run({"workload.samples=2"}, {"--events", "events"});
        for (int trial = 0; trial < 12; ++trial) {
            Words settings;
            for (KeyRange const& range : ranges_of(name))
                if (random() % 2 == 0)
                    settings.insert(settings.end(), {"--set", "accelerator." + range.key + "=" +
                                                                  range.values[random() % range.values.size()]});
            CAPTURE(name, trial, settings);
            auto const with = [&settings](Words first) {
                first.insert(first.end(), settings.begin(), settings.end());
                return first;
            };
            Words const run = with({"run", example.configuration().string(), "--set", "workload.samples=2"});
            Words in_lockstep = run;
            in_lockstep.insert(in_lockstep.end(), {"--set", "simulation.engine=lockstep"});
            std::string const decoupled = outcome(example, run, "run");
            CHECK(decoupled[0] != '2');
            CHECK(outcome(example, in_lockstep, "run") == decoupled);
            Words recorded = run;
            recorded.insert(recorded.end(), {"--events", "other"});
            CHECK(outcome(example, recorded, "run") == decoupled);
            bool const changes_work = std::any_of(settings.begin(), settings.end(), [](std::string const& one) {
                return one.find("entry_states") != std::string::npos;
            });
            if (!changes_work)
                CHECK(outcome(example, with({"whatif", "events"}), "whatif") == decoupled);
            stuck += decoupled[0] == '3' ? 1U : 0U;
        }
    }
    CHECK(stuck > 0);
}

TEST_CASE("The other commands know every example", "[examples]") {
    for (std::string const& name : all_examples) {
        CAPTURE(name);
        Example const example(name);
        example.run({}, {"--events", "events", "--report", "run.html", "--out", "a", "--critical-path"});
        example.run({"accelerator.clock_mhz=100"}, {"--out", "b"});
        CHECK_THAT(example.text("run.html"), Contains(name + ".yaml"));
        CHECK_THAT(example.done({"keys"}).out, Contains("accelerator.clock_mhz") && Contains("workload.samples"));
        CHECK_THAT(example.done({"sensitivities", "events"}).out, Contains("exact"));
        CHECK_THAT(example.done({"size-fifos", "events", "--within", "0"}).out, Contains("Proven: nothing below "));
        CHECK_THAT(example.done({"compare", "a", "b"}).out, Contains("accelerator.clock_mhz: 200 -> 100"));
        CHECK(example.call({"run", example.configuration().string(), "--set", "accelerator.window=3"}).exit_code == 2);
    }
}

TEST_CASE("Every example keeps its budget, and a first one can be made", "[examples]") {
    for (std::string const& name : all_examples) {
        CAPTURE(name);
        Example const example(name);
        example.done({"check", example.source(name + ".budget.yaml").string()});
        example.done({"check", "--init", example.configuration().string(), "--out", "first.yaml"});
        example.done({"check", "first.yaml"});
        CHECK(example.call({"check", "first.yaml", "--set", "accelerator.clock_mhz=1"}).exit_code == 1);
    }
}

TEST_CASE("A sweep varies the keys of an example", "[examples]") {
    Example const example("pipeline");
    example.done({"sweep", example.source("pipeline.sweep.yaml").string(), "--out", "swept"});
    CHECK_THAT(example.text("swept/results.csv"), Contains("4021") && Contains("8017"));
}

TEST_CASE("Waveforms show FIFOs and block RAMs of an example", "[examples]") {
    Example const example("convolution");
    example.run({}, {"--vcd", "run.vcd"});
    CHECK_THAT(example.text("run.vcd"), Contains("fifo_pixel") && Contains("bram_line_buffer") && Contains("addr"));
    Example const cyclic("cyclic");
    for (char const* engine : {"decoupled", "lockstep"})
        cyclic.run({"workload.samples=3", "workload.messages=20", std::string("simulation.engine=") + engine},
                   {"--vcd", std::string(engine) + ".vcd"});
    CHECK(cyclic.text("decoupled.vcd") == cyclic.text("lockstep.vcd"));
}

/// The first number gets through in 10 cycles, each further one takes an interval. Between samples the scaler drains,
/// 4 cycles, and begins anew with one.
TEST_CASE("The pipeline takes what its slowest loop says", "[examples]") {
    Example const example("pipeline");
    for (std::uint64_t const ii : {1U, 2U, 5U})
        for (std::uint64_t const n : {1U, 7U, 100U})
            for (std::uint64_t const samples : {1U, 3U}) {
                CAPTURE(ii, n, samples);
                std::uint64_t const first = ii * (n - 1) + 10;
                std::uint64_t const next = ii * (n - 1) + 5;
                CHECK(example.cycles({"accelerator.loops.scaler.scale.ii=" + std::to_string(ii),
                                      "workload.numbers=" + std::to_string(n),
                                      "workload.samples=" + std::to_string(samples)}) == first + (samples - 1) * next);
            }
}

TEST_CASE("The cyclic design takes two cycles per message, and three", "[examples]") {
    Example const example("cyclic");
    CHECK(example.cycles({}) == 4053);
    CHECK(example.cycles({"accelerator.controller.entry_states=0"}) == 4052);
    for (std::uint64_t const n : {1U, 2U, 10U})
        CHECK(example.cycles({"workload.messages=" + std::to_string(n)}) == 2 * n + 3);
    CHECK_THAT(example.text("out/samples.csv"), Contains("0,0,0,22,23,90"));  // 2 * (0 + ... + 9)
}

TEST_CASE("The cyclic design takes four cycles per message if it has three to begin one", "[examples]") {
    // A request is written in step 3 i + 1, its answer read in the step after: a cycle late.
    Example const example("cyclic");
    for (std::string const engine : {"decoupled", "lockstep"})
        for (std::uint64_t const n : {1U, 10U, 2025U})
            CHECK(example.cycles({"accelerator.loops.controller.exchange.ii=3", "simulation.engine=" + engine,
                                  "workload.messages=" + std::to_string(n)}) == 4 * n + 1);
}

TEST_CASE("The arbiter lets producers take turns, or the first one pass", "[examples]") {
    // A message is written in cycle 2 and found in cycle 3; 200 pass, one a cycle; the last is written in 203 and read
    // in 204, and its iteration is over in 206.
    Example const example("arbiter");
    std::string const priority = "accelerator.arbiter.round_robin=0";
    for (std::string const engine : {"decoupled", "lockstep"}) {
        CAPTURE(engine);
        CHECK(example.cycles({"simulation.engine=" + engine}) == 207);
        CHECK_THAT(example.text("out/samples.csv"), Contains(",1,199\n"));  // the second waits for one message
        CHECK(example.cycles({"simulation.engine=" + engine, priority}) == 207);
        CHECK_THAT(example.text("out/samples.csv"), Contains(",100,1\n"));
    }
    // The first producer leaves every other cycle to the second.
    example.cycles({priority, "accelerator.loops.first.produce.ii=2"});
    CHECK_THAT(example.text("out/samples.csv"), Contains(",1,199\n"));
}

TEST_CASE("What an arbiter finds is not retimed if it might find something else, but a sweep runs it", "[examples]") {
    Example const example("arbiter");
    example.cycles({}, "run");
    example.run({}, {"--events", "events"});
    example.done({"whatif", "events", "--out", "same"});
    CHECK(example.tables("same") == example.tables("run"));
    CommandResult const refused = example.call({"whatif", "events", "--set", "accelerator.loops.second.produce.ii=3"});
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("module arbiter reads second_message without waiting in cycle "));
    std::ofstream(example / "two.sweep.yaml")
        << "format: faster-sweep\nversion: 1\nbase: " << example.configuration().string()
        << "\ndimensions:\n  - {key: accelerator.loops.second.produce.ii, values: [1, 3]}\n";
    example.done({"sweep", (example / "two.sweep.yaml").string(), "--out", "sweep"});
    std::uint64_t const slower = example.cycles({"accelerator.loops.second.produce.ii=3"});
    CHECK(slower > 207);
    CHECK_THAT(example.text("sweep/results.csv"), Contains("207") && Contains(std::to_string(slower)));
    std::ofstream(example / "list.yaml")
        << "- {accelerator.loops.second.produce.ii: 3}\n- {accelerator.loops.first.produce.depth: 2}\n";
    example.done(
        {"whatif", "events", "--matrix", (example / "list.yaml").string(), "--csv", (example / "table.csv").string()});
    CHECK_THAT(example.text("table.csv"), Contains("accelerator.loops.second.produce.ii=3,unknown,,,\n"));
    example.done({"sensitivities", "events", "--csv", (example / "steps.csv").string()});
    CHECK_THAT(example.text("steps.csv"), Contains("accelerator.modules.first.starts,0,1,unknown,,,0,unknown\n"));
}

TEST_CASE("A stage of a read that its module's code could not have is not valid in tables either", "[examples]") {
    Example const example("memory");
    example.run({"accelerator.fifos.loaded.read_stage=1", "accelerator.loops.doubler.double.depth=4"},
                {"--events", "events"});
    example.done({"sensitivities", "events", "--csv", (example / "steps.csv").string()});
    CHECK_THAT(example.text("steps.csv"), Contains("accelerator.fifos.loaded.read_stage,1,2,invalid,,,0,invalid\n"));
    std::ofstream(example / "list.yaml") << "- {}\n- {accelerator.fifos.loaded.read_stage: 2}\n";
    CommandResult const refused = example.call({"whatif", "events", "--matrix", (example / "list.yaml").string()});
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err,
               Contains("list.yaml:2: loop doubler.double reads loaded in stage 2, behind other accesses"));
}

TEST_CASE("A stage that loops of tokens could not have is no what-if of theirs", "[examples]") {
    Example const example("pipeline");
    example.run({}, {"--events", "events"});
    CommandResult const refused = example.call({"whatif", "events", "--set", "accelerator.fifos.number.read_stage=3",
                                                "--set", "accelerator.fifos.product.write_latency=0"});
    CHECK(refused.exit_code == 2);
    CHECK_THAT(refused.err, Contains("loop scaler.scale reads number in stage 3, behind other accesses"));
}

/// With o = 4 bursts of 16 tokens under way, of R = 64 cycles: row "outstanding" of docs/memory-model.md, by hand.
TEST_CASE("An external memory of a slow clock keeps time for more than seven months", "[examples]") {
    // 3,000 samples of 6 million cycles of a millisecond: more picoseconds than 64 bits hold.
    Example const memory("memory");
    std::uint64_t const total =
        memory.cycles({"accelerator.memory.model=axi", "accelerator.memory.request_cycles=1000000",
                       "accelerator.clock_mhz=0.001", "workload.samples=3000"});
    CHECK(total > 18'446'744'074U);
    nlohmann::json const summary = nlohmann::json::parse(memory.text("out/summary.json"));
    for (nlohmann::json const& master : summary.at("external_memory").at("masters")) {
        CAPTURE(master.dump());
        CHECK(master.at("latency_least") >= 1'000'000U);
        CHECK(master.at("latency_most") <= 1'000'000U + 1000U);
    }
}

TEST_CASE("The loader of a memory waits as the page of the memory says", "[examples]") {
    Example const example("memory");
    auto const cycles = [&example](std::uint64_t outstanding, std::string const& engine) {
        return example.cycles({"workload.samples=1", "workload.numbers=1024", "simulation.engine=" + engine,
                               "accelerator.memory.outstanding=" + std::to_string(outstanding)});
    };
    constexpr std::uint64_t latency = 24 + 40, bursts = 1024 / 16, depth = 3;
    for (std::string const engine : {"decoupled", "lockstep"})
        for (std::uint64_t const outstanding : {1U, 2U, 4U, 5U, 16U}) {
            CAPTURE(engine, outstanding);
            std::uint64_t const m = bursts - 1;
            bool const is_bound = outstanding * 16 < latency + 16 + 1;
            std::uint64_t const loop =
                is_bound ? latency + 16 + m / outstanding * (latency + 16 + 1) + m % outstanding * 16 + depth
                         : latency + bursts * 16 + depth;
            // Behind the loader's last write, in its last stage: one cycle to the doubler, whose write is one later,
            // and one to the storer, which takes two.
            CHECK(cycles(outstanding, engine) == loop - 1 + 1 + 1 + 1 + 2);
        }
}

TEST_CASE("What is stored is asked for when it has been given, and in bursts", "[examples]") {
    Example const example("memory");
    std::string out =
        example.run({"workload.samples=1", "workload.numbers=1000", "accelerator.memory.output_address=536870972"}).out;
    out.erase(std::unique(out.begin(), out.end(), [](char one, char next) { return one == ' ' && next == ' '; }),
              out.end());
    CHECK_THAT(out, Contains("input 63 4,000 "));   // 62 of 16 tokens, and one of 8
    CHECK_THAT(out, Contains("output 64 4,000 "));  // one token, 62 times 16, and 7
}

TEST_CASE("A design that waits in a circle is reported, with who waits for whom", "[examples]") {
    Example const example("cyclic");
    for (char const* engine : {"decoupled", "lockstep"}) {
        CAPTURE(engine);
        CommandResult const result = example.call(
            {"run", example.source("deadlock.yaml").string(), "--set", std::string("simulation.engine=") + engine});
        CHECK(result.exit_code == 3);
        CHECK_THAT(result.err,
                   Contains("controller") && Contains("processor") && Contains("request") && Contains("response"));
        for (Words const& recorded : {Words{"--events", "events"}, Words{"--sensitivities"}}) {
            Words all{"run", example.source("deadlock.yaml").string(), "--set",
                      std::string("simulation.engine=") + engine};
            all.insert(all.end(), recorded.begin(), recorded.end());
            CommandResult const same = example.call(all);
            CHECK(same.exit_code == 3);
            CHECK(same.err == result.err);
        }
        CHECK_FALSE(fs::exists(example / "events"));
    }
}

TEST_CASE("A run of hours asks whether it is meant, of any design", "[examples]") {
    TempFolder const folder;
    folder.write("config.yaml", "");
    for (auto const& [binary, settings] : std::map<std::string, Words>{
             {CONVOLUTION_BINARY, {"--set", "workload.rows=4096", "--set", "workload.cols=4096"}},
             {HLS_PIPELINE_BINARY, {"--set", "workload.numbers=1000000"}}}) {
        Words words{"run", "config.yaml", "--set", "workload.samples=1000000"};
        words.insert(words.end(), settings.begin(), settings.end());
        CommandResult const result = run_command(binary, words, folder.path());
        CHECK(result.exit_code == 2);
        CHECK(result.out.empty());
        CHECK_THAT(result.err, Contains(": run: would take long (1000000 samples: about ") &&
                                   Contains("expected less than an hour of work, or run --force\n"));
        CHECK(result.seconds < 30);  // of which a sample or a few took most
    }
}

TEST_CASE("Ports and banks of the line buffer decide the convolution's pace", "[examples]") {
    struct Memory {
        Words settings;
        std::uint64_t interval;
    };
    std::string const brams = "accelerator.brams.line_buffer.";
    std::vector<Memory> const memories{
        {{brams + "ports=1"}, 3},
        {{brams + "ports=2"}, 2},
        {{brams + "ports=4"}, 1},
        {{brams + "partition.type=cyclic", brams + "partition.factor=2", brams + "partition.dimension=1"}, 1}};
    Example const example("convolution");
    for (Memory const& memory : memories)
        for (auto const& [rows, cols] : {std::pair{1, 1}, {4, 5}, {16, 16}}) {
            CAPTURE(memory.settings, rows, cols);
            Words settings = memory.settings;
            settings.insert(settings.end(), {"workload.samples=1", "workload.rows=" + std::to_string(rows),
                                             "workload.cols=" + std::to_string(cols)});
            auto const pixels = static_cast<std::uint64_t>(rows) * static_cast<std::uint64_t>(cols);
            CHECK(example.cycles(settings) == memory.interval * (pixels - 1) + 12);
            CHECK_THAT(lines_of(example.text("out/samples.csv")).at(1), Catch::Matchers::EndsWith(",0"));  // none wrong
        }
}

}  // namespace examples_test
