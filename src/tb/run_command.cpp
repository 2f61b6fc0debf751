#include "tb/run_command.hpp"

#include <chrono>
#include <filesystem>
#include <fmt/format.h>
#include <memory>
#include <stdexcept>

#include "kernel/base/files/output_file.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/config/load_config.hpp"
#include "kernel/config/resolved_config.hpp"
#include "kernel/replay/sensitivities.hpp"
#include "kernel/report/html/html_report.hpp"
#include "kernel/report/summary.hpp"
#include "kernel/report/text_report.hpp"
#include "tb/exit_codes.hpp"
#include "tb/progress_line.hpp"
#include "tb/recorded_events.hpp"
#include "tb/results_folder.hpp"
#include "tb/sample_pictures.hpp"
#include "tb/simulation/simulate.hpp"
#include "tb/workload_source.hpp"
#include "workload/files/trace.hpp"

namespace faster {

namespace {

using HostClock = std::chrono::steady_clock;

double seconds_since(HostClock::time_point start) {
    return std::chrono::duration<double>(HostClock::now() - start).count();
}

std::vector<Sensitivity> work_out_sensitivities(retiming::RecordedRun const& recorded, LoadedConfig const& loaded) {
    ProgressLine progress("retimings");
    return retiming::sensitivities(recorded, loaded,
                                   [&progress](std::size_t done, std::size_t all) { progress.show(done, all); });
}

void write_report(io::OutputFile const& file, RunRequest const& request, LoadedConfig const& loaded,
                  RunStatistics const& run, std::vector<SampleTimeline> const& timelines,
                  SamplePictures const& pictures) {
    std::vector<ResolvedKey> const keys = resolved_keys(loaded.config);
    std::string const title = std::filesystem::path(request.config).filename().string();
    file.commit(report::html_report({title, loaded.config.accelerator, run, keys, timelines, pictures.for_report()}));
}

}  // namespace

int run(RunRequest const& request) {
    std::vector<std::string> overrides = request.overrides;
    if (!request.trace.empty())
        overrides.push_back("workload.trace=" + request.trace);
    LoadedConfig loaded = load_config(request.config, overrides);
    // Before the work whose results would be lost.
    std::unique_ptr<ResultsFolder> const folder =
        request.out.empty() ? nullptr : std::make_unique<ResultsFolder>(request.out);
    auto const report_file = io::optional_output_file(request.report);
    auto const events_file = io::optional_output_file(request.events);

    report::HostTime host;
    auto start = HostClock::now();
    Stimulus const stimulus = load_stimulus(loaded);
    host.build_seconds = seconds_since(start);

    SamplePictures pictures(stimulus, static_cast<std::size_t>(request.images));
    start = HostClock::now();
    RunStatistics statistics;
    retiming::RecordedRun recorded;
    std::vector<SampleTimeline> timelines;
    {
        ProgressLine progress("samples");
        SimulationOptions options;
        options.probe = request.images > 0 ? &pictures : nullptr;
        options.critical_path = request.critical_path || report_file;
        options.recorded = request.sensitivities || events_file ? &recorded : nullptr;
        options.recordings = make_recordings(request.recording, loaded.config.accelerator, stimulus.samples.size());
        if (report_file)
            options.recordings.push_back(
                sample_timeline_recording(loaded.config.accelerator, stimulus.samples.size(), timelines));
        options.progress = [&](std::uint64_t done) { progress.show(done, stimulus.samples.size()); };
        statistics = simulate(loaded.config.accelerator, stimulus, loaded.config.simulation.engine, options);
    }
    host.simulate_seconds = seconds_since(start);

    if (statistics.deadlocked()) {
        fmt::print(stderr, "{}", report::deadlock_report(statistics));
        if (folder)
            folder->write_deadlock(loaded.config, statistics);
        return exit_deadlock;
    }
    if (std::string const left = leftover_tokens(statistics); !left.empty())
        throw std::logic_error("tokens are left at the end of the run: " + left);
    if (request.sensitivities)
        statistics.sensitivities = work_out_sensitivities(recorded, loaded);
    if (events_file)
        write_events(*events_file, loaded, recorded, statistics);
    if (folder && request.images > 0)
        folder->write(loaded.config, statistics, host,
                      [&](std::filesystem::path const& images) { pictures.write(images, statistics.samples); });
    else if (folder)
        folder->write(loaded.config, statistics, host);
    if (report_file)  // may lie in the folder
        write_report(*report_file, request, loaded, statistics, timelines, pictures);
    fmt::print("{}", report::text_report(loaded.config.accelerator, statistics, host));
    if (folder)
        fmt::print("\nwritten: {}\n", request.out);
    if (report_file)
        fmt::print("\nwritten: {}\n", request.report);
    if (events_file)
        fmt::print("\nwritten: {}\n", request.events);
    return exit_done;
}

int record(RecordRequest const& request) {
    LoadedConfig loaded = load_config(request.config, request.overrides);
    Stimulus const stimulus = with_explicit_triangles(load_stimulus(loaded));
    io::write_trace(stimulus, request.out);
    fmt::print("recorded {} samples, {} triangles: {}\n", stimulus.samples.size(), stimulus.triangles.size(),
               request.out);
    return exit_done;
}

}  // namespace faster
