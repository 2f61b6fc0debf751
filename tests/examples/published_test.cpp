// Designs whose cycles others have measured, by the programs of examples/published: latencies as HLS tools count them,
// one less than the total.
#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "support/command.hpp"
#include "support/explore_questions.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace published_test {

using namespace faster::test;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

std::map<std::string, std::string> const binaries{
    {"fifo_pair", FIFO_PAIR_BINARY},     {"buffer_pair", BUFFER_PAIR_BINARY}, {"merge_sort", MERGE_SORT_BINARY},
    {"dot_product", DOT_PRODUCT_BINARY}, {"dropping", DROPPING_BINARY},       {"cyclic", CYCLIC_BINARY}};

struct Row {
    std::string program, folder, configuration;
    Words settings;
    std::uint64_t latency;
};

std::vector<Row> const rows{
    {"fifo_pair", "published", "fifo_16.yaml", {}, 51},
    {"fifo_pair", "published", "fifo_16.yaml", {"workload.samples=16"}, 831},
    {"fifo_pair", "published", "fifo_multiply.yaml", {}, 83},
    {"fifo_pair", "published", "fifo_multiply.yaml", {"workload.samples=16"}, 1343},
    {"fifo_pair", "published", "fifo_multiply.yaml", {"workload.samples=16", "accelerator.fifos.word.depth=2"}, 1343},
    {"buffer_pair", "published", "buffer_pair.yaml", {}, 115},
    {"buffer_pair", "published", "buffer_pair.yaml", {"workload.samples=16"}, 115 + 15 * 82},
    {"merge_sort", "published", "merge_sort.yaml", {}, 407},
    {"merge_sort", "published", "merge_sort.yaml", {"workload.samples=3", "accelerator.calls=in_turn"}, 3 * 408 - 1},
    {"dot_product", "published", "dot_product.yaml", {}, 10099},
    {"dot_product", "published", "dot_product.yaml", {"accelerator.memory_read_latency=0"}, 10035},
    {"cyclic", "cyclic", "cyclic.yaml", {}, 4052},
    {"dropping", "published", "dropping.yaml", {}, 2036},  // measured: three more
};

Words with_settings(Words arguments, Words const& settings) {
    for (std::string const& setting : settings)
        arguments.insert(arguments.end(), {"--set", setting});
    return arguments;
}

std::string tables_of(fs::path const& out) {
    return content_of(out / "samples.csv") + content_of(out / "fifos.csv") + content_of(out / "loops.csv");
}

TEST_CASE("Published designs take the cycles that others measured, in both engines", "[examples]") {
    for (Row const& row : rows) {
        TempFolder const folder;
        fs::path const source = fs::path(FASTER_SOURCE_DIR) / "examples" / row.folder / row.configuration;
        std::string tables;
        for (std::string const engine : {"decoupled", "lockstep"}) {
            CAPTURE(source.string(), row.settings, engine);
            Words settings = row.settings;
            settings.push_back("simulation.engine=" + engine);
            require_done(run_command(binaries.at(row.program),
                                     with_settings({"run", source.string(), "--out", engine}, settings),
                                     folder.path()));
            auto const summary = nlohmann::json::parse(content_of(folder / engine / "summary.json"));
            CHECK(summary.at("total_cycles").get<std::uint64_t>() == row.latency + 1);
            CHECK((tables.empty() || tables == tables_of(folder / engine)));
            tables = tables_of(folder / engine);
        }
    }
}

/// The keys of loops that are not pipelined, of starts, buffers and calls.
TEST_CASE("What-if answers what a run of a published design would", "[examples]") {
    std::map<std::string, Words> const changes{
        {"fifo_pair",
         {"accelerator.loops.producer.send.states=7", "accelerator.loops.consumer.receive.entry_states=5",
          "accelerator.loops.consumer.receive.exit_states=0", "accelerator.modules.consumer.starts=40",
          "accelerator.fifos.word.write_latency=0", "accelerator.cores=2"}},
        {"buffer_pair",
         {"accelerator.loops.producer.fill.states=9", "accelerator.fifos.words.depth=1",
          "accelerator.fifos.words.depth=5", "accelerator.modules.producer.starts=11", "accelerator.cores=2"}}};
    for (auto const& [program, settings] : changes) {
        TempFolder const folder;
        std::string const name = program == "fifo_pair" ? "fifo_16" : program;
        fs::path const source = fs::path(FASTER_SOURCE_DIR) / "examples" / "published" / (name + ".yaml");
        Words const run{"run", source.string(), "--set", "workload.samples=5"};
        auto const call = [&folder, &binary = binaries.at(program)](Words const& arguments) {
            return run_command(binary, arguments, folder.path());
        };
        Words recorded = run;
        recorded.insert(recorded.end(), {"--events", "events"});
        require_done(call(recorded));
        for (std::string const& setting : settings) {
            CAPTURE(program, setting);
            Words other = with_settings(run, {setting});
            other.insert(other.end(), {"--out", "run"});
            require_done(call(other));
            require_done(call({"whatif", "events", "--set", setting, "--out", "whatif"}));
            CHECK(tables_of(folder / "whatif") == tables_of(folder / "run"));
            fs::remove_all(folder / "run");
            fs::remove_all(folder / "whatif");
        }
        CommandResult const refused =
            call({"whatif", "events", "--set",
                  "accelerator.calls=" + std::string(program == "fifo_pair" ? "overlapped" : "in_turn")});
        CHECK(refused.exit_code == 2);
        CommandResult const unsized = call({"size-fifos", "events", "--within", "5"});
        CHECK(unsized.exit_code == 2);
        CHECK_THAT(unsized.err, Catch::Matchers::Contains("hands over calls, which are not sized"));
        ExploreProcess const page(binaries.at(program), {"events"}, folder.path());
        auto const answer = ask(page, "start", {{"job", "sizing"}, {"within", 5}, {"set", Words()}}, 400);
        CHECK(program + ": " + answer["error"].get<std::string>() + "\n" == unsized.err);
        CHECK_THAT(refused.err, Catch::Matchers::Contains("decides which operations there are"));
    }
}

}  // namespace published_test
