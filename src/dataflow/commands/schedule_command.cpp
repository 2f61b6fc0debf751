#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/grouped_digits.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/command_paths.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/simulated_run.hpp"
#include "dataflow/commands/standard_commands.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/key_names.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/tools/schedule/scheduled_keys.hpp"

namespace dataflow {

namespace {

/// `schedule`.
struct ScheduleRequest {
    std::vector<std::string> reports;    ///< files
    std::string map;                     ///< file; empty: none
    std::string config;                  ///< file; empty: defaults, and no run
    std::vector<std::string> overrides;  ///< KEY=VALUE
    std::string out;                     ///< file; empty: stdout
};

std::vector<std::string> settings_of(schedule::Schedule const& schedule) {
    std::vector<std::string> settings;
    for (schedule::ScheduledKey const& key : schedule.keys)
        if (key.assumed != key.scheduled)
            settings.push_back(fmt::format("{}={}", key.key, key.scheduled));
    return settings;
}

constexpr std::string_view cannot_be_done = "cannot be done: ";

/// The total of a run in a process of its own, or why there is none.
processes::Task run_of(LoadedConfig const& loaded) {
    return {[loaded]() -> std::string {
        try {
            LoadedConfig own = loaded;
            RunStatistics const run = simulate(own);
            return run.deadlocked() ? "deadlock" : grouped(run.total_cycles);
        } catch (std::exception const& error) {
            return std::string(cannot_be_done) + error.what();
        }
    }};
}

std::string table_of(schedule::Schedule const& schedule, std::string const& version) {
    std::size_t width = 3;
    for (schedule::ScheduledKey const& key : schedule.keys)
        width = std::max(width, key.key.size());
    std::string table = fmt::format("Schedule of HLS {}\n  {:{}}  assumed  scheduled  by\n",
                                    version.empty() ? "of an unknown version" : version, "key", width);
    for (schedule::ScheduledKey const& key : schedule.keys)
        table += fmt::format("  {:{}}  {:7}  {:9}  {}\n", key.key, width, key.assumed, key.scheduled, key.source);
    if (!schedule.without.empty())
        table += "Without a counterpart\n";
    for (std::string const& line : schedule.without)
        table += "  " + line + "\n";
    return table;
}

/// Throws InputError if the scheduled run cannot be done.
std::string totals_of(LoadedConfig const& assumed, LoadedConfig const& scheduled) {
    processes::SignalWatch const watch;
    std::vector<processes::Outcome> const runs = processes::run_all({run_of(assumed), run_of(scheduled)}, 2, watch);
    auto const total = [&runs](std::size_t run) {
        return runs[run].kind == processes::Outcome::Kind::done
                   ? runs[run].output
                   : std::string(cannot_be_done) + "its process has no result";
    };
    if (total(1).rfind(cannot_be_done, 0) == 0)
        throw InputError("the scheduled run " + total(1));
    return fmt::format("Total cycles\n  assumed    {}\n  scheduled  {}\n", total(0), total(1));
}

/// Loops whose ports or dependences demand more here than the tool has given them.
std::string slower_loops_of(schedule::Schedule const& schedule, Machine const& machine) {
    std::string text;
    for (std::size_t const number : loops_of(machine)) {
        MachineLoop const& loop = machine.loops[number];
        std::string const key = loop_key_name(loop.timed_by, "ii");
        bool const is_scheduled = std::any_of(schedule.keys.begin(), schedule.keys.end(),
                                              [&key](schedule::ScheduledKey const& one) { return one.key == key; });
        if (is_scheduled && loop.interval.achieved > loop.interval.target)
            text += fmt::format("  {}: {} of the report, {} here, by {}\n", machine.loop_name(number),
                                loop.interval.target, loop.interval.achieved,
                                loop.interval.limited_by == "recurrence" ? "recurrence_ii"
                                                                         : "the ports of " + loop.interval.limited_by);
    }
    return text.empty() ? "" : "Intervals that the design does not reach\n" + text;
}

std::string as_comment(std::string const& text) {
    std::string comment;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t const end = std::min(text.find('\n', at), text.size());
        comment += "# " + text.substr(at, end - at) + "\n";
        at = end + 1;
    }
    return comment;
}

/// Returns the exit code; throws InputError on bad input.
int write_schedule(ScheduleRequest const& request) {
    CommandPaths paths;
    for (std::string const& report : request.reports)
        paths.reads(report);
    paths.reads(request.map);
    paths.reads(request.config);
    paths.writes("--out", request.out);
    auto const out = io::optional_output_file(request.out);
    schedule::SynthesisReport const report = schedule::read_synthesis_reports(request.reports);
    schedule::NameMap const names = request.map.empty() ? schedule::NameMap() : schedule::read_name_map(request.map);
    std::string const config = request.config.empty() ? "/dev/null" : request.config;
    LoadedConfig const assumed = load_config(config, request.overrides);
    schedule::Schedule const schedule = schedule::schedule_of(machine_of(assumed.config), report, names);
    std::vector<std::string> overrides = request.overrides;
    for (std::string const& setting : settings_of(schedule))
        overrides.push_back(setting);
    LoadedConfig const scheduled = load_config(config, overrides);
    std::string text = table_of(schedule, report.version) + slower_loops_of(schedule, machine_of(scheduled.config));
    if (!request.config.empty())
        text += totals_of(assumed, scheduled);
    if (out)
        out->commit(exported_yaml(scheduled.config));
    say("{}", out ? text : as_comment(text) + exported_yaml(scheduled.config));
    say_written({request.out});
    return exit_done;
}

}  // namespace

Subcommand schedule_command() {
    return {"schedule", "Take initiation intervals, depths and states from an HLS tool's synthesis report",
            [](CLI::App& command) {
                auto const request = std::make_shared<ScheduleRequest>();
                command.add_option("reports", request->reports, "Synthesis reports: csynth.xml, MODULE_csynth.xml")
                    ->required()
                    ->type_name("REPORT");
                command.add_option("--map", request->map, "Pairs of names: of the design, and of the report (YAML)")
                    ->type_name("FILE");
                command
                    .add_option("--config", request->config,
                                "Configuration to start from; it is run before and after, for the totals")
                    ->type_name("CONFIG");
                add_overrides(command, request->overrides);
                command
                    .add_option("--out", request->out, "Write the configuration here (stdout, the table as comments)")
                    ->type_name("FILE");
                return [request] { return write_schedule(*request); };
            }};
}

}  // namespace dataflow
