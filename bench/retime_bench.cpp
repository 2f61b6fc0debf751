// How long it takes to work out a recorded run with other timing: the distribution over random configurations.
//
//   faster_retime_bench EVENTS [CONFIGURATIONS] [SEED] [near|wide|deep|wild]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fmt/format.h>
#include <random>
#include <string>
#include <systemc>
#include <vector>

#include "dataflow/base/keep_memory.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/plain_config.hpp"
#include "support/random_stimulus.hpp"
#include "support/raster_machine.hpp"

namespace {

using namespace faster;
using testing::FifoId;
using testing::LoopId;

// The configuration's keys come with the modules, and those with libsystemc and its main().
[[maybe_unused]] bool const banner_is_off = setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1) == 0;

double processor_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

enum class Spread { near, wide, deep, wild };

/// near: a third of the FIFOs with depths up to 4, a quarter of the loops with a target II up to 3, a setup of 8 to 16
/// cycles. wide: all FIFOs, depths up to 16. deep: all FIFOs, depths up to 16384, each power of two as likely. wild:
/// every timing key, as the engine tests draw them. The machine's function, cores and clock as recorded. Deadlocks are
/// none of our business.
AcceleratorConfig drawn_from(std::uint64_t seed, Spread spread, AcceleratorConfig const& recorded) {
    AcceleratorConfig config = recorded;
    if (spread == Spread::wild) {
        testing::RandomConfigOptions options;
        options.fifo_depth = {1, 24};
        AcceleratorConfig const drawn = testing::random_config(seed, options);
        config.setups = drawn.setups;
        config.memories = drawn.memories;
        config.loops = drawn.loops;
        config.fifos = drawn.fifos;
        return config;
    }
    std::mt19937 random(static_cast<unsigned>(seed));
    auto const between = [&random](unsigned low, unsigned high) { return low + random() % (high - low + 1); };
    for (FifoId const id : testing::fifo_ids)
        if (spread == Spread::deep)
            config.fifo(id).depth = std::uint64_t{1} << between(0, 14);
        else if (between(0, 2) == 0 || spread == Spread::wide)
            config.fifo(id).depth = between(1, spread == Spread::wide ? 16 : 4);
    for (LoopId const id : testing::keyed_loop_ids)
        if (between(0, 3) == 0)
            config.loop(id).ii = between(1, 3);
    config.setup("rasterizer") = between(8, 16);
    for (FifoId const id : {FifoId::command, FifoId::fragment_depth, FifoId::fragment_index})
        config.fifo(id).depth = std::max<std::uint64_t>(fifo_of(config, id).depth, 2);
    return config;
}

struct Measured {
    std::uint64_t seed = 0;
    double milliseconds = 0;
    bool deadlocked = false;
};

template <class Run> Measured measure(Run const& run, AcceleratorConfig const& config) {
    double const start = processor_seconds();
    RunStatistics const retimed = replay::retime(run, testing::raster_machine(config));
    return {0, 1e3 * (processor_seconds() - start), retimed.deadlocked()};
}

/// The least of several times of one retiming, as a clock on the wall sees it.
double wall_milliseconds(replay::ScriptedRun const& run, AcceleratorConfig const& config, std::size_t jobs) {
    double least = 0;
    for (int round = 0; round < 6; ++round) {
        auto const start = std::chrono::steady_clock::now();
        replay::retime(run, testing::raster_machine(config), jobs);
        std::chrono::duration<double, std::milli> const took = std::chrono::steady_clock::now() - start;
        least = round == 0 ? took.count() : std::min(least, took.count());
    }
    return least;
}

void print_distribution(char const* name, std::vector<Measured>& all) {
    std::sort(all.begin(), all.end(), [](auto const& a, auto const& b) { return a.milliseconds < b.milliseconds; });
    fmt::print("{}:", name);
    for (auto const& [point, share] :
         {std::pair{"least", 0.0}, {"10 %", 0.1}, {"median", 0.5}, {"90 %", 0.9}, {"most", 1.0}}) {
        Measured const& at = all[static_cast<std::size_t>(std::lround(share * static_cast<double>(all.size() - 1)))];
        fmt::print("  {} {:.2f} ms (seed {})", point, at.milliseconds, at.seed);
    }
    fmt::print("\n");
}

}  // namespace

int sc_main(int argc, char** argv) {
    if (argc < 2) {
        fmt::print(stderr, "usage: faster_retime_bench EVENTS [CONFIGURATIONS] [SEED] [near|wide|deep|wild]\n");
        return 2;
    }
    keep_freed_memory();
    std::size_t const count = argc > 2 ? std::stoul(argv[2]) : 100;
    std::uint64_t const seed = argc > 3 ? std::stoull(argv[3]) : 1;
    std::string const only = argc > 4 ? argv[4] : "";
    double start = processor_seconds();
    events::EventFile const file = events::read_event_file(argv[1]);
    AcceleratorConfig const& recorded = accelerator_of(file.loaded.config);
    fmt::print("read in {:.1f} ms\n", 1e3 * (processor_seconds() - start));
    fmt::print("as recorded, from the file: {:.2f} ms\n", measure(file.run, recorded).milliseconds);
    start = processor_seconds();
    replay::ScriptedRun const scripted(file.run);
    fmt::print("made ready in {:.1f} ms, {} phrases and pieces of them that differ\n",
               1e3 * (processor_seconds() - start), scripted.book().size());
    fmt::print("as recorded, the first time: {:.2f} ms\n", measure(scripted, recorded).milliseconds);
    fmt::print("as recorded, made ready: {:.2f} ms\n", measure(scripted, recorded).milliseconds);
    std::size_t const jobs = jobs_or_host_cores(0);
    fmt::print("as recorded, made ready, wall clock on one thread and on {}: {:.2f} and {:.2f} ms\n", jobs,
               wall_milliseconds(scripted, recorded, 1), wall_milliseconds(scripted, recorded, jobs));
    fmt::print("made ready, {} random configurations, seeds from {}, processor time\n", count, seed);
    for (auto const& [name, spread] :
         {std::pair{"near", Spread::near}, {"wide", Spread::wide}, {"deep", Spread::deep}, {"wild", Spread::wild}}) {
        if (!only.empty() && only != name)
            continue;
        std::vector<Measured> all;
        for (std::uint64_t i = seed; all.size() < count; ++i) {
            Measured measured = measure(scripted, drawn_from(i, spread, recorded));
            measured.seed = i;
            if (!measured.deadlocked)
                all.push_back(measured);
        }
        if (!all.empty())
            print_distribution(name, all);
    }
    return 0;
}
