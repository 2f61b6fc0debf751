#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/base/files/atomic_folder.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/events/retimed_config.hpp"
#include "dataflow/tools/resources/fifo_cost.hpp"
#include "dataflow/tools/sizing/sizing_files.hpp"

namespace dataflow {

namespace {

/// `faster-sim size-fifos`.
struct SizeFifosRequest {
    std::string events;         ///< file
    double within_percent = 0;  ///< of what unbounded FIFOs take, more
    std::string out;            ///< folder; empty: none
    double luts_per_ramb36 = CostWeights().luts_per_ramb36;
    unsigned front_points = 12;
    unsigned jobs = 0;  ///< threads; 0: the host's cores
    std::vector<std::string> overrides;
    bool force = false;  ///< however long it takes, whatever memory there is
};

io::FolderKind const sizing_folder{
    "sizing", "sizing.json", {"pareto.csv", "depths.yaml", "sizing.html"}, "faster-sizing"};

sizing::SizingOptions options_of(SizeFifosRequest const& request) {
    sizing::SizingOptions options;
    options.within_percent = request.within_percent;
    options.weights.luts_per_ramb36 = request.luts_per_ramb36;
    options.front_points = request.front_points;
    options.jobs = static_cast<unsigned>(jobs_or_host_cores(request.jobs));
    return options;
}

/// For each bound, each FIFO is looked at a few times. One core is enough to break a bound, unless they share a memory.
double retimings_of(SizeFifosRequest const& request, Machine const& machine) {
    constexpr double per_fifo = 7;
    double const cores = machine.external_memory ? 1 : static_cast<double>(machine.cores);
    return per_fifo * static_cast<double>(fifos_of(machine).size() * (request.front_points + 1)) / cores;
}

sizing::Sizing worked_out(SizeFifosRequest const& request, events::EventFile const& recorded, RunConfig const& config) {
    ProgressLine line("steps");
    try {
        return sizing::size_fifos(recorded.run, config, options_of(request), line.teller());
    } catch (InputError const& error) {
        throw InputError(request.events + ": " + error.what());
    }
}

void write_files(SizeFifosRequest const& request, sizing::Sizing const& sizing, io::AtomicFolder& folder) {
    std::string const title =
        fmt::format("{} size-fifos {} --within {}", program_name(),
                    std::filesystem::path(request.events).filename().string(), request.within_percent);
    io::write_file(folder.path() / "sizing.json", sizing::sizing_json(sizing));
    io::write_file(folder.path() / "pareto.csv", sizing::pareto_csv(sizing));
    io::write_file(folder.path() / "depths.yaml", sizing::depths_yaml(sizing, title));
    folder.commit();
}

/// Returns the exit code; throws InputError on bad input.
int print_fifo_sizes(SizeFifosRequest const& request) {
    CommandPaths paths;
    paths.reads(request.events);
    paths.writes("--out", request.out, sizing_folder);
    events::EventFile const recorded = events::read_event_file(request.events);
    LoadedConfig const changed = events::retimed_config(recorded.loaded, request.overrides);
    auto const folder = request.out.empty() ? nullptr : std::make_unique<io::AtomicFolder>(request.out, sizing_folder);
    Machine const machine = machine_of(changed.config);
    sizing::require_sizable(machine);
    announce_retimings("size-fifos", recorded.run, machine, retimings_of(request, machine), request.force);
    auto const start = HostClock::now();
    sizing::Sizing const sizing = worked_out(request, recorded, changed.config);
    double const seconds = seconds_since(start);
    if (folder)
        write_files(request, sizing, *folder);
    say("{}\nretimed {} times a core, in {:.1f} s\n", sizing::sizing_text(sizing), sizing.retimed_cores, seconds);
    say_written({request.out});
    return exit_done;
}

}  // namespace

Subcommand size_fifos_command() {
    return {"size-fifos",
            "Find the cheapest FIFO depths with which a recorded run takes hardly longer than with unbounded ones",
            [](CLI::App& command) {
                auto const request = std::make_shared<SizeFifosRequest>();
                add_events(command, request->events);
                command
                    .add_option("--within", request->within_percent,
                                "How much longer than with unbounded FIFOs, in per cent")
                    ->required()
                    ->type_name("PERCENT")
                    ->check(number_in(0, sizing::most_within_percent));
                command
                    .add_option("--out", request->out, "Write depths.yaml, sizing.json and pareto.csv to this folder")
                    ->type_name("DIR");
                command
                    .add_option("--ramb36-luts", request->luts_per_ramb36,
                                "LUTs that a block RAM of 36 Kbit is worth (300.53)")
                    ->type_name("LUTS")
                    ->check(number_in(sizing::least_luts_of_ramb36, sizing::most_luts_of_ramb36));
                command
                    .add_option("--points", request->front_points,
                                "Bounds at which cost is weighed against cycles; 0: none")
                    ->type_name("N")
                    ->capture_default_str()
                    ->check(integer_in(0, sizing::most_front_points));
                add_jobs(command, request->jobs, "Threads");
                add_overrides(command, request->overrides);
                add_force(command, request->force);
                command.footer(
                    "Only depths are searched; kinds stay as configured, auto following accelerator.fifo_rules. "
                    "Cores that share a memory are all retimed for each question; the answer says what is "
                    "proven then.");
                return [request] { return print_fifo_sizes(*request); };
            }};
}

}  // namespace dataflow
