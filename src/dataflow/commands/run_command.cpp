#include "dataflow/commands/run_command.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>
#include <utility>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/on_threads.hpp"
#include "dataflow/base/program_name.hpp"
#include "dataflow/commands/exit_codes.hpp"
#include "dataflow/commands/options.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/recorded_events.hpp"
#include "dataflow/commands/results_folder.hpp"
#include "dataflow/commands/run_size.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/commands/simulated_run.hpp"
#include "dataflow/commands/waveform_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/keys.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/config/resolved_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/outcomes.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/sensitivities.hpp"
#include "dataflow/tools/explore/replayed_timeline.hpp"
#include "dataflow/tools/report/html/deadlock_html.hpp"
#include "dataflow/tools/report/html/html_report.hpp"
#include "dataflow/tools/report/latencies.hpp"
#include "dataflow/tools/report/summary.hpp"
#include "dataflow/tools/report/text_report.hpp"

namespace dataflow {

namespace {

constexpr std::size_t most_samples = 1000;

/// Bars of the finest levels that a page holds, about eight bytes each.
constexpr std::size_t most_bars = 5'000'000;
constexpr std::size_t most_bars_of_sample = 50'000;

std::string title_of(std::string const& config) { return std::filesystem::path(config).filename().string(); }

/// Each once.
std::vector<SampleStatistics> shown_samples(RunStatistics const& run, std::vector<std::size_t> const& asked) {
    std::vector<std::size_t> numbers;
    for (report::StandoutSample const& standout : report::standout_samples(run))
        numbers.push_back(standout.sample->sample);
    numbers.insert(numbers.end(), asked.begin(), asked.end());
    std::vector<SampleStatistics> samples;
    std::vector<bool> is_there(run.samples.size(), false);
    for (std::size_t const number : numbers) {
        if (!is_there[number])
            samples.push_back(run.samples[number]);
        is_there[number] = true;
    }
    return samples;
}

std::vector<report::PackedTimeline> packed_timelines(replay::RecordedRun const& recorded, RunStatistics const& run,
                                                     std::vector<SampleStatistics> const& samples) {
    if (samples.empty())
        return {};
    ProgressLine progress("timelines");
    CountedProgress done(samples.size(), progress.teller());
    std::size_t const bars = std::min(most_bars / samples.size(), most_bars_of_sample);
    std::vector<report::PackedTimeline> packed(samples.size());
    explore::replay_timelines(recorded, run.machine, samples, [&](std::size_t i, SampleTimeline timeline) {
        packed[i] = report::packed_timeline(run.machine, report::with_endless_waits(std::move(timeline), run), bars);
        done.one_more();
    });
    return packed;
}

/// That of the core with the circle first.
std::vector<SampleStatistics> stuck_samples(RunStatistics const& run) {
    constexpr std::size_t most_shown = 10;
    std::vector<SampleStatistics> samples = run.unfinished;
    std::vector<StuckProcess> const circle = run.wait_cycle();
    std::stable_partition(samples.begin(), samples.end(), [&circle](SampleStatistics const& sample) {
        return !circle.empty() && sample.core == circle.front().core;
    });
    samples.resize(std::min(samples.size(), most_shown));
    return samples;
}

/// The samples that --report-samples asks for: "all", or numbers and ranges such as 0-9,617. Errors: InputError for
/// samples that there are not, and for more than a page can hold.
std::vector<std::size_t> parse_report_samples(std::string const& text, std::size_t samples) {
    if (text.empty())
        return {};
    std::string const list = text == "all" && samples > 0 ? fmt::format("0-{}", samples - 1) : text;
    std::vector<std::size_t> numbers = parse_numbers("--report-samples", list, samples);
    if (numbers.size() > most_samples)
        throw InputError(
            fmt::format("--report-samples {}: {} samples, expected at most {}", text, numbers.size(), most_samples));
    return numbers;
}

/// Writes the page of a finished run, which was recorded. It gets the timelines of the median sample, the slowest, the
/// fastest, and those asked for.
void write_report(io::OutputFile const& file, std::string const& config, LoadedConfig const& loaded,
                  RunStatistics const& run, replay::RecordedRun const& recorded, std::vector<std::size_t> const& asked,
                  RunExtras const& extras) {
    std::vector<ResolvedKey> const keys = resolved_keys(loaded.config);
    std::vector<report::PackedTimeline> const timelines = packed_timelines(recorded, run, shown_samples(run, asked));
    file.commit(report::html_report({title_of(config), run, keys, timelines, extras.pictures()}));
}

/// Writes the page of a run that got stuck, with the timelines of samples that did not end. `overrides`: its settings.
void write_deadlock_page(io::OutputFile const& file, std::string const& config,
                         std::vector<std::string> const& overrides, LoadedConfig const& loaded,
                         RunStatistics const& run, replay::RecordedRun const& recorded) {
    report::RunCommand const command{program_name() + " run " + config, overrides};
    file.commit(report::deadlock_html(title_of(config), command, run, resolved_keys(loaded.config),
                                      packed_timelines(recorded, run, stuck_samples(run))));
}

namespace fs = std::filesystem;

std::vector<Sensitivity> work_out_sensitivities(replay::RecordedRun const& recorded, LoadedConfig const& loaded) {
    ProgressLine progress("retimings");
    return replay::sensitivities(recorded, loaded, progress.teller());
}

/// Before the work whose results would be lost.
struct Outputs {
    explicit Outputs(RunRequest const& request)
        : folder(request.out.empty() ? nullptr : std::make_unique<ResultsFolder>(request.out, request.report)),
          report(io::optional_output_file(request.report)),
          events(io::optional_output_file(request.events)) {}

    std::unique_ptr<ResultsFolder> folder;
    std::unique_ptr<io::OutputFile> report;
    std::unique_ptr<io::OutputFile> events;
};

void require_distinct_paths(RunRequest const& request, RunConfig const& config) {
    CommandPaths paths;
    paths.reads(request.config);
    paths.reads(config);
    paths.writes("--out", request.out, ResultsFolder::kind());
    paths.writes("--report", request.report);
    paths.writes("--events", request.events);
    add_paths(request.recording, paths);
}

/// What the cores would take if everything were there at once, for the roofline.
void add_compute_alone(replay::RecordedRun const& recorded, LoadedConfig const& loaded, RunStatistics& run) {
    if (!run.memory || !recorded.memory)
        return;
    RunConfig ideal = loaded.config;
    find_key("accelerator.memory.model")->write(ideal, KeyValue{std::string("ideal")});
    try {
        RunStatistics const alone = replay::retime(recorded, machine_of(ideal));
        if (!alone.deadlocked())
            run.memory->compute_alone = alone.total_cycles;
    } catch (replay::NotRetimable const&) {  // nobody knows, then
    }
}

int give_up(RunRequest const& request, std::vector<std::string> const& overrides, LoadedConfig const& loaded,
            RunStatistics const& run, replay::RecordedRun const& recorded, Outputs const& outputs) {
    warn("{}", report::deadlock_report(run));
    if (outputs.folder)
        outputs.folder->write_deadlock(loaded.config, run);
    if (outputs.report)
        write_deadlock_page(*outputs.report, request.config, overrides, loaded, run, recorded);
    for (std::string const& written : {request.out, request.report, written_files(request.recording)})
        if (!written.empty())
            warn("\nwritten: {}\n", written);
    return exit_deadlock;
}

}  // namespace

int run(RunRequest const& request, RunExtras& extras) {
    extras.check(!request.out.empty() || !request.report.empty());
    std::vector<std::string> overrides = request.overrides;
    for (std::string const& setting : extras.overrides(request.overrides))
        overrides.push_back(setting);
    LoadedConfig loaded = load_config(request.config, overrides);
    require_distinct_paths(request, loaded.config);
    Outputs const outputs(request);

    report::HostTime host;
    auto start = HostClock::now();
    auto const workload = simulated_design().load_workload(loaded);
    host.build_seconds = seconds_since(start);
    Machine const machine = machine_of(loaded.config);
    std::size_t const samples = workload->samples();
    std::vector<std::size_t> const report_samples = parse_report_samples(request.report_samples, samples);
    announce_run(loaded.config, machine, *workload, request.force);

    std::vector<Recording> recordings = make_recordings(
        request.recording, machine, samples,
        [&outputs](fs::path const& file) { return outputs.folder ? outputs.folder->place_of(file) : file; });
    announce_waveform(request.recording, machine, samples, request.force,
                      [&](SimulationOptions const& options) { return simulate(loaded.config, *workload, options); });

    say_warnings(workload->warnings());

    extras.before(*workload);
    start = HostClock::now();
    RunStatistics statistics;
    replay::RecordedRun recorded;
    {
        ProgressLine progress("samples");
        SimulationOptions options;
        options.at_any_size = request.force;
        options.jobs = jobs_or_host_cores(request.jobs);
        options.figures_alone = workload->leaves_figures_alone();
        options.critical_path = request.critical_path || outputs.report;
        options.hazards = request.hazards;
        options.recorded = request.sensitivities || outputs.events || outputs.report ? &recorded : nullptr;
        options.recordings = std::move(recordings);
        options.progress = [&](std::uint64_t done) { progress.show(done, samples); };
        statistics = simulate(loaded.config, *workload, options);
    }
    host.simulate_seconds = seconds_since(start);

    if (statistics.deadlocked())
        return give_up(request, overrides, loaded, statistics, recorded, outputs);
    statistics.warnings = workload->warnings();
    for (std::string const& warning : extras.warnings(statistics.samples)) {
        say_warnings({warning});
        statistics.warnings.push_back(warning);
    }
    if (std::string const left = leftover_tokens(statistics); !left.empty())
        throw InputError(
            "tokens are left at the end of the run, unread: " + left +
            ", expected modules that read all that is written, or keeps_tokens() where it need not be, of the " +
            "end that writes it, or of the stream in an HlsDesign");
    if (std::string const kept = kept_tokens(statistics); !kept.empty()) {
        statistics.warnings.push_back("tokens are left at the end of the run, unread: " + kept);
        say_warnings({statistics.warnings.back()});
    }
    add_compute_alone(recorded, loaded, statistics);
    if (request.sensitivities) {
        statistics.sensitivities = work_out_sensitivities(recorded, loaded);
        statistics.alternatives = replay::alternatives(recorded, loaded);
    }
    if (outputs.folder && extras.writes_pictures())
        outputs.folder->write(loaded.config, statistics, host, workload->table(),
                              [&](std::filesystem::path const& images) { extras.write(images, statistics.samples); });
    else if (outputs.folder)
        outputs.folder->write(loaded.config, statistics, host, workload->table());
    if (outputs.events)  // these may lie in the folder
        write_events(*outputs.events, loaded, recorded, statistics);
    if (outputs.report)
        write_report(*outputs.report, request.config, loaded, statistics, recorded, report_samples, extras);
    say("{}", report::text_report(statistics, host));
    say_written({request.out, request.report, request.events, written_files(request.recording)});
    return exit_done;
}

Subcommand run_command(MakeRunExtras const& make_extras) {
    return {
        "run", "Simulate a configuration and print its report", [make_extras](CLI::App& command) {
            auto const request = std::make_shared<RunRequest>();
            std::shared_ptr<RunExtras> const extras = make_extras();
            command.add_option("config", request->config, "Configuration file (YAML)")->required()->type_name("CONFIG");
            command
                .add_option("--out", request->out,
                            "Write summary.json, samples.csv, fifos.csv and loops.csv to this folder, and what else "
                            "docs/formats.md names")
                ->type_name("DIR");
            command
                .add_option("--report", request->report,
                            "Write the run as one HTML page; of a deadlock, who waits for whom")
                ->type_name("FILE.html");
            command
                .add_option("--report-samples", request->report_samples,
                            "Samples whose timelines the page shows besides the median, the slowest and the fastest, "
                            "e.g. 0-9,617, or all")
                ->type_name("LIST")
                ->needs("--report");
            command.add_option("--events", request->events, "Write what the run did, for whatif and sensitivities")
                ->type_name("FILE");
            command.add_flag("--critical-path", request->critical_path,
                             "Trace along which operations the total comes about");
            command.add_flag("--sensitivities", request->sensitivities,
                             "Work out what one step of each timing key changes (retimes the run about 150 times)");
            add_force(command, request->force, ", or writes a waveform of more than 2 GB");
            command.add_flag("--hazards", request->hazards,
                             "Look for iterations that read a word before one shortly before them has written it");
            add_jobs(command, request->jobs,
                     "Host cores to use at most: several only where the design's cores share no memory and nothing but "
                     "figures is asked for, two with --events or --hazards, otherwise one");
            extras->declare(command);
            add_overrides(command, request->overrides);
            add_recording_options(command, request->recording);
            return [request, extras] { return run(*request, *extras); };
        }};
}

}  // namespace dataflow
