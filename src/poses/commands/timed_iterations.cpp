#include "poses/commands/timed_iterations.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>
#include <sstream>

#include "dataflow/base/files/output_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/progress_line.hpp"
#include "dataflow/commands/recorded_events.hpp"
#include "dataflow/commands/waveform_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "dataflow/tools/report/text_report.hpp"
#include "dataflow/tools/resources/power.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "modules/core/faster_simulation.hpp"

namespace faster {

namespace {

constexpr char done_mark = 'r';
constexpr char deadlock_mark = 'd';
constexpr char input_error_mark = 'i';

/// For the way from one process to another: every number comes back as it was.
std::string text_of(Estimate const& estimate) {
    return fmt::format(" {} {} {}", estimate.low, estimate.typical, estimate.high);
}

std::string text_of(RunStatistics const& run) {
    RunPower const power = power_of(run);
    std::string text =
        std::to_string(run.total_cycles) + text_of(power.energy_mj) + text_of(power.static_w + power.ps_w);
    text += ' ' + std::to_string(run.samples.empty() ? 0 : run.samples.front().counters.size());
    for (SampleStatistics const& sample : run.samples)
        for (std::uint64_t const value : sample.counters)
            text += ' ' + std::to_string(value);
    return text;
}

SimulatedIteration iteration_from(std::string const& text) {
    SimulatedIteration iteration;
    IterationCost& cost = iteration.cost;
    std::istringstream numbers(text);
    numbers >> cost.cycles;
    for (Estimate* const estimate : {&cost.energy_mj, &cost.idle_w})
        numbers >> estimate->low >> estimate->typical >> estimate->high;
    std::ptrdiff_t of_sample = 0;
    numbers >> of_sample;
    std::vector<std::uint64_t> const values{std::istream_iterator<std::uint64_t>(numbers), {}};
    for (auto from = values.begin(); from != values.end(); from += of_sample)
        iteration.counters.push_back(counters_from({from, from + of_sample}));
    return iteration;
}

/// The first sample whose counters differ, for the message; empty: none.
std::string first_difference(std::vector<SampleCounters> const& counted, std::vector<SampleCounters> const& expected) {
    auto const [at, other] = std::mismatch(counted.begin(), counted.end(), expected.begin(), expected.end());
    bool const is_same = at == counted.end() && other == expected.end();
    return is_same ? "" : fmt::format("sample {}", at - counted.begin());
}

/// What one process does, and sends back.
std::string simulated(LoadedConfig const& loaded, Stimulus const& stimulus, IterationRecording const* recording) {
    try {
        Machine const machine = machine_of(loaded.config);
        auto const events = io::optional_output_file(recording != nullptr ? recording->events : "");
        replay::RecordedRun recorded;
        SimulationOptions options;
        options.recorded = events ? &recorded : nullptr;
        if (recording != nullptr)
            options.recordings = make_recordings(recording->request, machine, stimulus.samples.size());
        RunStatistics const run =
            simulate(accelerator_of(loaded.config), stimulus, loaded.config.simulation.engine, options);
        if (run.deadlocked())
            return deadlock_mark + report::deadlock_report(run);
        if (events)
            write_events(*events, loaded, recorded, run);
        return done_mark + text_of(run);
    } catch (InputError const& error) {
        return input_error_mark + std::string(error.what());
    }
}

SimulatedIteration result_of(processes::Outcome const& outcome, std::size_t number) {
    if (outcome.kind != processes::Outcome::Kind::done)
        throw HostError(fmt::format(
            "iteration {}: the simulation crashed, failed or took more than an hour, expected a result", number));
    std::string const text = outcome.output.substr(1);
    if (outcome.output.front() == input_error_mark)
        throw InputError(text);
    if (outcome.output.front() == deadlock_mark)
        throw DeadlockedIteration(text);
    return iteration_from(text);
}

/// Before any work is done for it.
void announce_waveform(IterationRecording const& recording, LoadedConfig const& loaded, Stimulus stimulus,
                       ScoredPoses const& iteration) {
    workload::set_poses(iteration.poses, stimulus);
    announce_waveform(recording.request, machine_of(loaded.config), stimulus.samples.size(), recording.force,
                      [&](SimulationOptions const& options) {
                          return simulate(accelerator_of(loaded.config), stimulus, loaded.config.simulation.engine,
                                          options);
                      });
}

}  // namespace

SimulatedIteration simulate_iteration(LoadedConfig const& loaded, Stimulus const& stimulus, std::size_t number) {
    processes::SignalWatch const watch;
    return result_of(processes::run_all({{[&] { return simulated(loaded, stimulus, nullptr); }}}, 1, watch).front(),
                     number);
}

std::vector<IterationCost> simulate_iterations(LoadedConfig const& loaded, Stimulus const& observed,
                                               std::vector<ScoredPoses> const& iterations,
                                               std::optional<IterationRecording> const& recording, std::size_t jobs) {
    if (recording)
        announce_waveform(*recording, loaded, observed, iterations.at(recording->iteration));
    std::vector<processes::Task> tasks;
    for (std::size_t i = 0; i < iterations.size(); ++i)
        tasks.push_back({[&, i] {
            Stimulus stimulus = observed;
            workload::set_poses(iterations[i].poses, stimulus);
            return simulated(loaded, stimulus, recording && recording->iteration == i ? &*recording : nullptr);
        }});
    processes::SignalWatch const watch;
    ProgressLine progress("iterations simulated");
    std::vector<processes::Outcome> const outcomes = processes::run_all(tasks, jobs, watch, progress.teller());
    std::vector<IterationCost> costs;
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        SimulatedIteration const iteration = result_of(outcomes[i], i);
        std::string const difference = first_difference(iteration.counters, iterations[i].counters);
        if (!difference.empty())
            throw std::runtime_error(
                fmt::format("iteration {}: the model's counters of {} are not the untimed ones", i, difference));
        costs.push_back(iteration.cost);
    }
    return costs;
}

}  // namespace faster
