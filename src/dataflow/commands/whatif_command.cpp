#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <vector>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/results_folder.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/plain_text.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/config/settings_list.hpp"
#include "dataflow/run/events/event_file.hpp"
#include "dataflow/run/events/retimed_config.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/retime_many.hpp"
#include "dataflow/tools/compare/compare.hpp"
#include "dataflow/tools/compare/comparison_report.hpp"
#include "dataflow/tools/compare/read_run.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "dataflow/tools/report/text_report.hpp"
#include "dataflow/tools/report/whatif_table.hpp"

namespace dataflow {

namespace {

/// `faster-sim whatif`.
struct WhatifRequest {
    std::string events;                  ///< file
    std::vector<std::string> overrides;  ///< KEY=VALUE
    std::string out;                     ///< folder; empty: print only
    std::string matrix;                  ///< file of configurations; empty: only the one
    std::string csv;                     ///< file, for the matrix; empty: print only
    std::int64_t top = 3;                ///< rows per list of the comparison
    bool critical_path = false;          ///< of the other timing
    bool full = false;                   ///< prints the report of the other timing as well
    bool force = false;                  ///< however long it takes, whatever memory there is
};

runs::RunRecord record_of(std::string const& name, events::EventFile const& recorded) {
    return runs::run_record(name, recorded.summary, recorded.samples);
}

runs::Comparison with_recorded(std::string const& name, events::EventFile const& recorded, LoadedConfig const& changed,
                               RunStatistics const& run) {
    std::vector<ResolvedKey> keys = resolved_keys(changed.config);
    auto const is_unknown = [](ResolvedKey const& key) { return !decides_figures(key.key); };  // to an event file
    keys.erase(std::remove_if(keys.begin(), keys.end(), is_unknown), keys.end());
    std::string const summary = report::summary_json(keys, run, {});
    return runs::compare(record_of(name, recorded), runs::run_record("whatif", summary, run.samples));
}

/// What looks like a mistake of the workload does so with any timing.
std::vector<std::string> recorded_warnings(events::EventFile const& recorded) {
    Json const summary = Json::parse(recorded.summary);
    return summary.value("warnings", std::vector<std::string>());
}

int retime_one(WhatifRequest const& request, events::EventFile const& recorded, LoadedConfig const& changed,
               report::HostTime host) {
    CommandPaths paths;
    paths.reads(request.events);
    paths.writes("--out", request.out, ResultsFolder::kind());
    std::unique_ptr<ResultsFolder> const folder =
        request.out.empty() ? nullptr : std::make_unique<ResultsFolder>(request.out);
    Machine const machine = machine_of(changed.config);
    announce(size_of_retimings("whatif", recorded.run, machine, 1), request.force);
    auto const start = HostClock::now();
    RunStatistics run = request.critical_path ? replay::retime_with_path(replay::ScriptedRun(recorded.run), machine)
                                              : replay::retime(recorded.run, machine);
    run.warnings = recorded_warnings(recorded);
    host.simulate_seconds = seconds_since(start);
    if (run.deadlocked()) {
        warn("{}", report::deadlock_report(run));
        if (folder) {
            folder->write_deadlock(changed.config, run);
            warn("\nwritten: {}\n", request.out);
        }
        return exit_deadlock;
    }
    if (run.samples.size() != recorded.samples.size() || !leftover_tokens(run).empty())
        throw InputError(request.events +
                         ": what its processes write is not what they read, expected the file of a run");
    if (folder)
        folder->write(changed.config, run, host);
    say("{}", runs::comparison_text(with_recorded(request.events, recorded, changed, run),
                                    static_cast<std::size_t>(request.top)));
    if (request.full)
        say("\n{}", report::text_report(run, host));
    say_written({request.out});
    return exit_done;
}

/// The machine of a matrix's row. Complaints name the row instead of --set.
Machine machine_of_row(std::string const& matrix, Settings const& row, LoadedConfig const& base,
                       replay::RecordedRun const& run) {
    try {
        Machine machine = machine_of(events::retimed_config(base, row.overrides).config);
        replay::require_run_on(machine, run);
        return machine;
    } catch (InputError const& error) {
        std::string what = error.what();
        if (what.rfind("--set ", 0) == 0)
            what.erase(0, 6);
        throw InputError(fmt::format("{}:{}: {}", matrix, row.line, what));
    }
}

/// A key that a row may change, with its value in the recorded run.
std::string example_setting(RunConfig const& recorded) {
    Keys const keys = retimable_keys(recorded);
    auto const integer =
        std::find_if(keys.begin(), keys.end(), [](Key const& key) { return key.kind == KeyKind::integer; });
    Key const& key = integer != keys.end() ? *integer : keys.front();  // a clock, if nothing else
    return key.name() + ": " + plain_text(key.read(recorded));
}

int retime_matrix(WhatifRequest const& request, events::EventFile const& recorded, LoadedConfig const& base) {
    CommandPaths paths;
    paths.reads(request.events);
    paths.reads(request.matrix);
    paths.writes("--csv", request.csv);
    auto const csv = io::optional_output_file(request.csv);
    std::vector<Settings> const list = read_settings_list(request.matrix, example_setting(recorded.loaded.config));
    std::vector<Machine> machines;
    report::WhatifTable table(machine_of(recorded.loaded.config), record_of(request.events, recorded).total_cycles);
    for (Settings const& row : list) {
        machines.push_back(machine_of_row(request.matrix, row, base, recorded.run));
        table.add_row(fmt::format("{}", fmt::join(row.overrides, " ")), machines.back());
    }
    if (!request.force)
        for (Machine const& machine : machines)
            require_memory(size_of_retimings("whatif", recorded.run, machine, 1));
    announce_retimings("whatif", recorded.run, machine_of(base.config), static_cast<double>(list.size()),
                       request.force);
    {
        ProgressLine progress("configurations");
        std::size_t done = 0;
        replay::retime_many(recorded.run, machines, [&](std::size_t i, std::optional<RunStatistics> const& run) {
            table.set_result(i, run);
            progress.show(++done, machines.size());
        });
    }
    if (csv)
        csv->commit(table.csv());
    say("{}", table.text());
    say_written({request.csv});
    return exit_done;
}

/// Returns the exit code: exit_deadlock if the configuration deadlocks, unless it is one of a matrix. Throws InputError
/// on bad input.
int whatif(WhatifRequest const& request) {
    auto const start = HostClock::now();
    events::EventFile const recorded = events::read_event_file(request.events);
    report::HostTime host;
    host.build_seconds = seconds_since(start);
    LoadedConfig const changed = events::retimed_config(recorded.loaded, request.overrides);
    return request.matrix.empty() ? retime_one(request, recorded, changed, host)
                                  : retime_matrix(request, recorded, changed);
}

}  // namespace

Subcommand whatif_command() {
    return {"whatif", "Say how long a recorded run would take with other timing, without running it",
            [](CLI::App& command) {
                auto const request = std::make_shared<WhatifRequest>();
                add_events(command, request->events);
                add_overrides(command, request->overrides);
                CLI::Option* const out = command.add_option("--out", request->out, "Write the files of run --out");
                out->type_name("DIR");
                command
                    .add_option("--matrix", request->matrix,
                                "A row for each configuration of this file: a YAML list of maps from keys to values")
                    ->type_name("FILE")
                    ->excludes(out);
                command.add_option("--csv", request->csv, "Write the rows of --matrix to this file")
                    ->type_name("FILE")
                    ->needs("--matrix");
                command
                    .add_option("--top", request->top, "Rows of each list of the comparison; the others are counted")
                    ->type_name("N")
                    ->capture_default_str()
                    ->check(integer_in(0, 1000000));
                command
                    .add_flag("--critical-path", request->critical_path,
                              "Trace along which operations the total comes about, for --out and --full")
                    ->excludes("--matrix");
                command.add_flag("--full", request->full, "Print the report of run as well")->excludes("--matrix");
                add_force(command, request->force);
                return [request] { return whatif(*request); };
            }};
}

}  // namespace dataflow
