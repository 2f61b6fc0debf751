#include <string>
#include <vector>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/events/retimed_config.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/run/replay/slack.hpp"
#include "dataflow/tools/report/sensitivity_report.hpp"

namespace dataflow {

namespace {

/// `faster-sim sensitivities`.
struct SensitivitiesRequest {
    std::string events;                  ///< file
    std::vector<std::string> overrides;  ///< KEY=VALUE: of the run with these
    std::string csv;                     ///< file; empty: none
    std::string json;                    ///< file; empty: none
    bool force = false;                  ///< however long it takes, whatever memory there is
};

/// Of steps, of other choices, and of the search for slack.
double retimings_of(LoadedConfig const& loaded) {
    constexpr double per_key = 8;
    return per_key * static_cast<double>(timing_keys(loaded.config).size());
}

RunStatistics with_sensitivities(events::EventFile const& recorded, LoadedConfig const& loaded) {
    RunStatistics run = replay::retime(recorded.run, machine_of(loaded.config));
    if (run.deadlocked())
        throw InputError("with these settings the run deadlocks in cycle " + std::to_string(run.deadlock_cycle()) +
                         ", expected settings with which it ends");
    ProgressLine line("retimings");
    TellProgress const progress = line.teller();
    run.sensitivities = replay::sensitivities(recorded.run, loaded, progress);
    run.alternatives = replay::alternatives(recorded.run, loaded);
    replay::find_slack(recorded.run, loaded, run.total_cycles, run.sensitivities, progress);
    return run;
}

/// Returns the exit code; throws InputError on bad input.
int print_sensitivities(SensitivitiesRequest const& request) {
    CommandPaths paths;
    paths.reads(request.events);
    paths.writes("--csv", request.csv);
    paths.writes("--json", request.json);
    events::EventFile const recorded = events::read_event_file(request.events);
    auto const csv = io::optional_output_file(request.csv);
    auto const json = io::optional_output_file(request.json);
    LoadedConfig const loaded = events::retimed_config(recorded.loaded, request.overrides);
    announce_retimings("sensitivities", recorded.run, machine_of(loaded.config), retimings_of(loaded), request.force);
    RunStatistics const run = with_sensitivities(recorded, loaded);
    if (csv)
        csv->commit(report::sensitivities_csv(run));
    if (json)
        json->commit(report::sensitivities_file_json(run));
    say("{}", report::sensitivities_text(run).substr(1));
    say_written({request.csv, request.json});
    return exit_done;
}

}  // namespace

Subcommand sensitivities_command() {
    return {"sensitivities", "Say what one step of each timing key changes for a recorded run, and which have slack",
            [](CLI::App& command) {
                auto const request = std::make_shared<SensitivitiesRequest>();
                add_events(command, request->events);
                command.add_option("--csv", request->csv, "Write a row per key and direction to this file")
                    ->type_name("FILE");
                command.add_option("--json", request->json, "Write the same as JSON to this file")->type_name("FILE");
                add_force(command, request->force);
                add_overrides(command, request->overrides);
                return [request] { return print_sensitivities(*request); };
            }};
}

}  // namespace dataflow
