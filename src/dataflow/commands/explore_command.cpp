#include <CLI/CLI.hpp>
#include <atomic>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <memory>
#include <string>
#include <unistd.h>
#include <vector>

#include "dataflow/base/files/scratch.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/program_output.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/explore_server.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/run_size.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/simulated_run.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/tools/explore/answers.hpp"
#include "dataflow/tools/explore/exploration.hpp"
#include "dataflow/tools/report/text_report.hpp"

namespace dataflow {

namespace {

/// `explore`.
struct ExploreRequest {
    std::string input;                   ///< event file, or a configuration to be run first
    std::vector<std::string> overrides;  ///< KEY=VALUE, of that run
    int port = 0;                        ///< 0: any
    bool force = false;                  ///< however long the run takes, whatever memory there is
};

events::EventFile read_recorded(ExploreRequest const& request) {
    if (!request.overrides.empty())
        throw InputError(request.input + ": --set " + request.overrides.front() +
                         ": expected no --set with an event file; the page has a control for each key");
    return events::read_event_file(request.input);
}

/// Without what came of it. Nothing if it deadlocks, which has been said then.
std::unique_ptr<events::EventFile> record(ExploreRequest const& request) {
    auto recorded = std::make_unique<events::EventFile>();
    recorded->loaded = load_config(request.input, request.overrides);
    auto const workload = simulated_design().load_workload(recorded->loaded);
    say_warnings(workload->warnings());
    announce_run(recorded->loaded.config, machine_of(recorded->loaded.config), *workload, request.force);
    ProgressLine progress("samples");
    SimulationOptions options;
    options.recorded = &recorded->run;
    options.at_any_size = request.force;
    options.progress = [&](std::uint64_t done) { progress.show(done, workload->samples()); };
    RunStatistics const run = simulate(recorded->loaded.config, *workload, options);
    if (!run.deadlocked())
        return recorded;
    warn("{}", report::deadlock_report(run));
    return nullptr;
}

explore::Exploration::Require require_room(ExploreRequest const& request) {
    if (request.force)
        return {};
    return [](replay::RecordedRun const& run, Machine const& machine) {
        require_memory(size_of_retimings("explore", run, machine, 1));
    };
}

/// In a process of its own: SystemC's modules are made once in each. It ends with this one.
events::EventFile run_again(std::string const& yaml, std::atomic<bool> const& is_ending) {
    std::string const name = "explore-" + std::to_string(getpid());
    io::Scratch const folder(std::filesystem::temp_directory_path() / name, io::Scratch::Kind::folder);
    std::filesystem::path const configuration = folder.path() / "config.yaml", events = folder.path() / "events";
    std::ofstream(configuration) << yaml;
    std::string const program = std::filesystem::read_symlink("/proc/self/exe");
    program_output({program, "run", configuration, "--events", events}, "", [&is_ending] { return !is_ending; });
    return events::read_event_file(events);
}

std::string host_name() {
    char name[256] = "this host";
    gethostname(name, sizeof name - 1);
    return name;
}

/// Returns the exit code: exit_deadlock if the configuration deadlocks. Throws InputError on bad input.
int explore_run(ExploreRequest const& request) {
    std::unique_ptr<events::EventFile> recorded =
        is_event_file(request.input) ? std::make_unique<events::EventFile>(read_recorded(request)) : record(request);
    if (!recorded)
        return exit_deadlock;
    std::atomic<bool> is_ending = false;
    explore::Exploration exploration(std::filesystem::path(request.input).filename().string(),
                                     std::move(recorded->loaded), std::move(recorded->run), require_room(request),
                                     [&is_ending](std::string const& yaml) { return run_again(yaml, is_ending); });
    recorded.reset();  // its samples' figures are of no use
    explore::Answers answers(exploration);
    ExploreServer server(answers, request.port);
    say("{}\n\nOn another machine, open the same address after\n  ssh -N -L {}:127.0.0.1:{} {}\n\nCtrl-C ends it.\n",
        server.address(), server.port(), server.port(), host_name());
    finish_saying();
    server.serve([&is_ending] { is_ending = true; });
    return exit_done;
}

}  // namespace

Subcommand explore_command() {
    return {"explore", "Show a recorded run as a page whose timing can be changed, with what that changes",
            [](CLI::App& command) {
                auto const request = std::make_shared<ExploreRequest>();
                command
                    .add_option("input", request->input,
                                "Event file of run --events, or a configuration file to be run first")
                    ->required()
                    ->type_name("EVENTS|CONFIG");
                command.add_option("--port", request->port, "Port of 127.0.0.1; 0: any that is free")
                    ->type_name("PORT")
                    ->capture_default_str()
                    ->check(integer_in(0, 65535));
                add_force(command, request->force);
                add_overrides(command, request->overrides);
                return [request] { return explore_run(*request); };
            }};
}

}  // namespace dataflow
