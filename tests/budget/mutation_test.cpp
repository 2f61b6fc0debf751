#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "faster/config/adopt_trace.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/trace.hpp"
#include "support/command.hpp"
#include "support/counters.hpp"
#include "support/plain_config.hpp"
#include "support/temp_folder.hpp"
#include "support/test_run.hpp"

namespace mutation_test {

using namespace faster;
using testing::bram_count;
using testing::BramId;
using testing::FifoId;
using testing::LoopId;
using testing::test_run;
using Json = nlohmann::json;
namespace fs = std::filesystem;

// Changes every timing parameter of a core, one at a time, and asks faster-sim check whether a budget broke and whom it
// blames. Whether it had to break is found out without any budget: by two simulations, and comparing their figures.

std::string const source = FASTER_SOURCE_DIR;
std::vector<std::string> const traces{"edge_heavy", "fragment_heavy", "full_window", "banana"};
char const* const page_name = "/docs/budget-mutations.md";

/// The modules that the block RAMs belong to.
constexpr std::array<char const*, bram_count> bram_owners{"edge_map_builder", "edge_map_builder", "inlier_unit"};

/// The last FIFO and the last loop that the design of the budgets has.
constexpr FifoId last_fifo = FifoId::result;
constexpr LoopId last_loop = LoopId::sweep;

struct Mutation {
    std::string key;
    std::string value;
    std::vector<std::string> items;  ///< what has to be blamed: beginnings of figures' names
    std::string fifo;                ///< what a deadlock has to name; empty: none is expected
};

std::string text_of(Cycles value) { return std::to_string(value); }

void add_fifo_mutations(std::vector<Mutation>& all) {
    for (FifoId const id : testing::fifo_ids) {
        if (last_fifo < id)
            break;
        std::vector<std::string> const items{std::string("fifos.") + id.name + "."};
        for (char const* const depth : {"1", "3"})
            all.push_back({fifo_key_name(id, "depth"), depth, items, id.name});
        all.push_back({fifo_key_name(id, "kind"), "memory", items, id.name});  // another read latency
        if (Cycles const latency = testing::default_write_latency(id); latency > 0)
            all.push_back({fifo_key_name(id, "write_latency"), text_of(latency - 1), items, id.name});
    }
}

void add_loop_mutations(std::vector<Mutation>& all) {
    for (LoopId const id : testing::loop_ids) {
        if (last_loop < id)
            break;
        std::string const module = id.module;
        std::vector<std::string> const items{"loops." + module + "." + id.name + ".", "modules." + module + "."};
        all.push_back({loop_key_name(id, "ii"), "2", items, ""});
        all.push_back({loop_key_name(id, "recurrence_ii"), "2", items, ""});
        all.push_back({loop_key_name(id, "depth"), text_of(testing::default_depth(id) + 1), items, ""});
    }
    all.push_back({"accelerator.loops.rasterizer.setup.depth",
                   text_of(testing::setup_depth_of({}) + 1),
                   {"modules.rasterizer."},
                   ""});
}

std::vector<Mutation> all_mutations() {
    std::vector<Mutation> all;
    add_fifo_mutations(all);
    add_loop_mutations(all);
    for (BramId const id : testing::bram_ids)
        for (char const* const ports : {"1", "3"})
            all.push_back(
                {bram_key_name(id, "ports"),
                 ports,
                 {std::string("brams.") + id.name + ".", std::string("modules.") + bram_owners[index_of(id)] + "."},
                 ""});
    return all;
}

/// The figures that the shipped budgets guard, by hand: stalls and other cycles, occupancies, intervals, samples. No
/// depths, latencies and ports: a change that moves nothing in time is no breach.
std::vector<std::uint64_t> guarded_figures(RunStatistics const& run) {
    std::vector<std::uint64_t> figures{run.total_cycles};
    for (SampleStatistics const& sample : run.samples)
        figures.insert(figures.end(), {sample.start_cycle, sample.end_cycle, testing::counters_of(sample).inlier});
    for (CoreStatistics const& core : run.cores) {
        for (FifoStatistics const& fifo : core.fifos)
            figures.insert(figures.end(), {fifo.full_stall_cycles, fifo.empty_stall_cycles, fifo.max_occupancy});
        for (LoopStatistics const& loop : core.loops)
            figures.insert(figures.end(),
                           {loop.ii, loop.iterations, loop.port_conflict_cycles, loop.recurrence_cycles});
        for (ProcessStatistics const& process : core.processes)
            figures.insert(figures.end(), process.cycles.begin(), process.cycles.end());
    }
    return figures;
}

/// Nothing if the run gets stuck.
std::vector<std::uint64_t> simulated(std::string const& trace, std::vector<std::string> overrides) {
    overrides.emplace_back("accelerator.raster_cores=1");
    LoadedConfig loaded = load_config(source + "/configs/faster_zcu102.yaml", overrides);
    Stimulus const stimulus = files::read_trace(source + "/traces/" + trace);
    adopt_trace(loaded, stimulus.width, stimulus.height, stimulus.window, stimulus.fraction, stimulus.samples.size());
    RunStatistics const run = test_run(accelerator_of(loaded.config), stimulus, Engine::decoupled).statistics;
    return run.deadlocked() ? std::vector<std::uint64_t>{} : guarded_figures(run);
}

Json checked(Mutation const& mutation) {
    test::TempFolder const folder;
    std::vector<std::string> words{"check", "--json", folder / "c.json", "--set", mutation.key + "=" + mutation.value};
    for (std::string const& trace : traces)
        words.push_back(source + "/configs/budgets/" + trace + "_1_core.yaml");
    test::CommandResult const result = test::run_command(FASTER_SIM_BINARY, words, folder.path());
    INFO(result.err);
    REQUIRE(result.exit_code <= 1);
    return Json::parse(test::content_of(folder / "c.json")).at("budgets");
}

bool begins_with(std::string const& text, std::string const& beginning) { return text.rfind(beginning, 0) == 0; }

/// Whether one of the first figures in a list of what moved belongs to the parameter's items. `settings` do not count,
/// or there would be nothing to find out.
bool names(Json const& list, Mutation const& mutation) {
    constexpr std::size_t shown = 5;  // as printed
    for (std::size_t i = 0; i < std::min(shown, list.size()); ++i)
        for (std::string const& item : mutation.items)
            if (begins_with(list[i].at("item").get<std::string>() + ".", item))
                return true;
    return false;
}

/// The kinds of figures that give the culprit away: "shape", "work", "waiting", or "deadlock".
std::set<std::string> blamed_by(Json const& budget, Mutation const& mutation) {
    if (budget.at("status") == "deadlocked") {
        auto const message = budget.at("message").get<std::string>();
        std::string const circle = message.substr(0, message.find("all stuck"));
        bool const named = !mutation.fifo.empty() && circle.find(" " + mutation.fifo + ",") != std::string::npos;
        return named ? std::set<std::string>{"deadlock"} : std::set<std::string>{};
    }
    std::set<std::string> kinds;
    for (auto const& [list, kind] : {std::pair{"shapes", "shape"}, {"work", "work"}, {"waiting", "waiting"}})
        if (names(budget.at("moved").at(list), mutation))
            kinds.insert(kind);
    return kinds;
}

struct Tally {
    std::size_t mutations = 0, moving = 0, cases = 0, moved = 0, caught = 0, false_alarms = 0, named = 0;
    std::size_t named_without_shape = 0;
};

/// One mutation in one budget. `kinds` collects what gave it away.
bool try_out(Mutation const& mutation, bool has_moved, Json const& budget, Tally& tally, std::set<std::string>& kinds) {
    bool const is_caught = budget.at("status") != "passed";
    std::set<std::string> blame = is_caught ? blamed_by(budget, mutation) : std::set<std::string>{};
    CHECK(is_caught == has_moved);
    CHECK((!is_caught || !blame.empty()));
    kinds.insert(blame.begin(), blame.end());
    tally.cases += 1;
    tally.moved += has_moved ? 1U : 0U;
    tally.caught += has_moved && is_caught ? 1U : 0U;
    tally.false_alarms += is_caught && !has_moved ? 1U : 0U;
    tally.named += blame.empty() ? 0U : 1U;
    blame.erase("shape");
    tally.named_without_shape += blame.empty() ? 0U : 1U;
    return is_caught;
}

/// One mutation in all budgets: a row of the page.
std::string row_of(Mutation const& mutation, std::vector<std::vector<std::uint64_t>> const& before, Tally& tally) {
    Json const budgets = checked(mutation);
    std::size_t moved = 0, caught = 0;
    std::set<std::string> kinds;
    for (std::size_t i = 0; i < traces.size(); ++i) {
        CAPTURE(mutation.key, mutation.value, traces[i]);
        bool const has_moved = simulated(traces[i], {mutation.key + "=" + mutation.value}) != before[i];
        moved += has_moved ? 1U : 0U;
        caught += try_out(mutation, has_moved, budgets[i], tally, kinds) ? 1U : 0U;
    }
    tally.mutations += 1;
    tally.moving += moved > 0 ? 1U : 0U;
    return fmt::format("| `{}` | {} | {} | {} | {} |\n", mutation.key.substr(std::string("accelerator.").size()),
                       mutation.value, moved, moved == 0 ? "-" : std::to_string(caught),
                       kinds.empty() ? "-" : fmt::format("{}", fmt::join(kinds, ", ")));
}

std::string page_of(std::string const& rows, Tally const& tally) {
    auto const percent = [](std::size_t part, std::size_t whole) {
        return 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    };
    return fmt::format(
        "# Do the shipped budgets notice?\n\n"
        "Written by the test \"Every change of a timing parameter that moves a figure breaks the budget, and is "
        "named\"\n"
        "(`tests/budget/mutation_test.cpp`), which fails if this page says anything else than it finds.\n"
        "`FASTER_APPROVE=1 build/ci/bin/faster_budget_tests` writes the page anew.\n\n"
        "Each timing parameter of a core is changed on its own. Two simulations without any budget tell whether a "
        "figure that\n"
        "budgets guard (cycles, stalls, occupancies, intervals) moves; then `faster-sim check --set` runs the "
        "one-core\n"
        "budgets of {}.\n\n"
        "- **{} changes**, {} of them move a figure in at least one budget; the others cost or save nothing there.\n"
        "- Of {} pairs of change and budget, {} move a figure. **Caught: {} ({:.1f} %)**; {} false alarms.\n"
        "- **Named: {} ({:.1f} %)**: what moved lists a figure of the parameter's own FIFO, loop, block RAM or module "
        "among\n"
        "  the five largest of its kind. That the settings are listed too does not count.\n"
        "- Shapes (depths, latencies, intervals, ports) show a parameter directly. Work, waiting and the circle of a "
        "deadlock\n"
        "  are what is left to go by if the model's code changes and no parameter does: these alone name it in\n"
        "  **{} ({:.1f} %)**.\n\n"
        "| parameter, `accelerator.` | set to | moves figures in (of {}) | caught in | named by |\n"
        "| --- | --- | --- | --- | --- |\n{}",
        fmt::join(traces, ", "), tally.mutations, tally.moving, tally.cases, tally.moved, tally.caught,
        percent(tally.caught, tally.moved), tally.false_alarms, tally.named, percent(tally.named, tally.moved),
        tally.named_without_shape, percent(tally.named_without_shape, tally.moved), traces.size(), rows);
}

TEST_CASE("Every change of a timing parameter that moves a figure breaks the budget, and is named") {
    std::vector<std::vector<std::uint64_t>> before;
    before.reserve(traces.size());
    for (std::string const& trace : traces)
        before.push_back(simulated(trace, {}));
    Tally tally;
    std::string rows;
    for (Mutation const& mutation : all_mutations())
        rows += row_of(mutation, before, tally);
    CHECK(tally.moving >= 30);
    std::string const page = page_of(rows, tally);
    if (std::getenv("FASTER_APPROVE") != nullptr)
        std::ofstream(source + page_name) << page;
    INFO("FASTER_APPROVE=1 writes docs/budget-mutations.md anew");
    CHECK(test::content_of(source + page_name) == page);
}

}  // namespace mutation_test
