#include "kernel/explore/exploration.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "kernel/base/input_error.hpp"
#include "kernel/base/on_threads.hpp"
#include "kernel/config/design.hpp"
#include "kernel/events/retimed_config.hpp"
#include "kernel/explore/figures_json.hpp"
#include "kernel/explore/keys_json.hpp"
#include "kernel/explore/loop_schedules.hpp"
#include "kernel/explore/replayed_timeline.hpp"
#include "kernel/replay/critical_path_of.hpp"
#include "kernel/replay/retime.hpp"
#include "kernel/replay/retime_together.hpp"
#include "kernel/replay/sensitivities.hpp"
#include "kernel/report/critical_path_report.hpp"
#include "kernel/report/html/graph_data.hpp"
#include "kernel/report/html/run_data.hpp"
#include "kernel/report/html/timeline_data.hpp"
#include "kernel/report/sensitivity_report.hpp"
#include "kernel/sizing/sizing_files.hpp"

namespace faster::explore {

namespace {

/// The core whose last sample ends last, the first of them.
std::size_t last_core(RunStatistics const& run) {
    auto const ends_before = [](CoreStatistics const& a, CoreStatistics const& b) { return a.end_cycle < b.end_cycle; };
    return static_cast<std::size_t>(std::max_element(run.cores.begin(), run.cores.end(), ends_before) -
                                    run.cores.begin());
}

}  // namespace

Exploration::Exploration(std::string title, LoadedConfig recorded, replay::RecordedRun run, Require require)
    : title_(std::move(title)),
      recorded_(std::move(recorded)),
      run_(std::move(run)),
      require_(std::move(require)),
      scripted_(run_, run_.lead(machine_of(recorded_.config))) {}

RunConfig Exploration::changed(Overrides const& overrides) const {
    RunConfig config = events::retimed_config(recorded_, overrides).config;
    if (require_)
        require_(run_, machine_of(config));
    return config;
}

Json Exploration::design() const {
    Machine const machine = machine_of(recorded_.config);
    return {{"format", "faster-exploration"},
            {"samples", run_.tape.samples()},
            {"cores_are", machine.cores_are},
            {"remark", machine.remark},
            {"cycle_classes", report::cycle_class_data(machine)},
            {"path_causes", report::path_cause_data(machine)},
            {"graph", report::graph_data(machine)},
            {"keys", keys_json(recorded_.config)}};
}

std::shared_ptr<RunStatistics const> Exploration::retimed_run(Overrides const& overrides) {
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        if (kept_run_.run && kept_run_.overrides == overrides)
            return kept_run_.run;
    }
    auto run = std::make_shared<RunStatistics const>(replay::retime(scripted_, machine_of(changed(overrides))));
    std::lock_guard<std::mutex> const lock(mutex_);
    kept_run_ = {overrides, run};
    return run;
}

Json Exploration::retimed(Overrides const& overrides) {
    RunConfig const config = changed(overrides);
    Json figures = figures_json(*retimed_run(overrides));
    figures["schedules"] = loop_schedules(config);
    figures["yaml"] = exported_yaml(config);
    return figures;
}

/// With its critical path, unless it deadlocks.
RunStatistics Exploration::retimed_with_path(Machine const& machine) const {
    if (run_.memory)
        return replay::retime_together(scripted_, machine, true);
    RunStatistics run = replay::retime(scripted_, machine);
    if (run.deadlocked())
        return run;
    std::size_t const core = last_core(run);
    replay::CoreOptions options;
    options.leave_trails = true;
    replay::Cores const cores = replay::retime_cores(scripted_, machine, {core}, options);
    run.critical_path = replay::critical_path_of({cores.front().get()}, machine);
    run.critical_path->core = core;
    return run;
}

Json Exploration::critical_path(Overrides const& overrides) const {
    RunStatistics const run = retimed_with_path(machine_of(changed(overrides)));
    return run.critical_path ? report::critical_path_json(run) : Json();
}

/// The last one is kept: who zooms asks for its parts.
std::shared_ptr<Exploration::KeptTimeline const> Exploration::kept_timeline(Overrides const& overrides,
                                                                            std::size_t sample) {
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        if (kept_ && kept_->overrides == overrides && kept_->timeline.sample == sample)
            return kept_;
    }
    Machine const machine = machine_of(changed(overrides));
    std::shared_ptr<RunStatistics const> const run = retimed_run(overrides);
    if (run->deadlocked())
        throw InputError("the run deadlocks, expected one that ends");
    auto const made = std::make_shared<KeptTimeline const>(
        KeptTimeline{overrides, machine, replayed_timeline(scripted_, machine, run->samples[sample])});
    std::lock_guard<std::mutex> const lock(mutex_);
    return kept_ = made;
}

Json Exploration::timeline(Overrides const& overrides, std::size_t sample, Cycles from, Cycles to) {
    if (sample >= run_.tape.samples())
        throw InputError(fmt::format("sample = {}, expected one below {}", sample, run_.tape.samples()));
    std::shared_ptr<KeptTimeline const> const kept = kept_timeline(overrides, sample);
    Cycles const end = to == 0 ? kept->timeline.end : to;
    Json json = report::timeline_data(kept->machine, cut(kept->timeline, from, end));
    json["sample_begin"] = kept->timeline.begin;
    json["sample_end"] = kept->timeline.end;
    return json;
}

Job::Work Exploration::sensitivities(Overrides const& overrides) const {
    changed(overrides);  // or there is no room for it
    LoadedConfig const loaded = events::retimed_config(recorded_, overrides);
    return [this, loaded](Job::Progress const& progress) {
        RunStatistics run;
        run.sensitivities = replay::sensitivities(run_, loaded, progress.tell);
        run.total_cycles = replay::retime(scripted_, machine_of(loaded.config)).total_cycles;
        return Json{{"total_cycles", run.total_cycles}, {"sensitivities", report::sensitivities_json(run)}};
    };
}

Job::Work Exploration::sizing(Overrides const& overrides, double within_percent) const {
    RunConfig const config = changed(overrides);
    return [this, config, within_percent](Job::Progress const& progress) {
        sizing::SizingOptions options;
        options.within_percent = within_percent;
        options.jobs = static_cast<unsigned>(jobs_or_host_cores(0));
        options.before_retiming = progress.check;
        Json sizing = Json::parse(sizing::sizing_json(sizing::size_fifos(run_, config, options, progress.tell)));
        Machine const machine = machine_of(config);
        sizing["answer"]["cost_of_cores"] = cost_of_cores(machine, sizing["answer"]["cost_luts"]);
        for (Json& point : sizing["front"])
            point["cost_of_cores"] = cost_of_cores(machine, point["cost_luts"]);
        return sizing;
    };
}

}  // namespace faster::explore
