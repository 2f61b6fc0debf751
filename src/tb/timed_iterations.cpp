#include "tb/timed_iterations.hpp"

#include <fmt/format.h>
#include <sstream>
#include <stdexcept>

#include "faster/faster_config.hpp"
#include "kernel/base/files/output_file.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/base/process_pool.hpp"
#include "kernel/config/design.hpp"
#include "kernel/figures/power.hpp"
#include "kernel/report/text_report.hpp"
#include "modules/faster_simulation.hpp"
#include "tool/progress_line.hpp"
#include "tool/recorded_events.hpp"
#include "tool/waveform_size.hpp"
#include "workload/build_stimulus.hpp"

namespace faster {

namespace {

constexpr char cost_mark = 'c';
constexpr char deadlock_mark = 'd';
constexpr char difference_mark = 'x';
constexpr char input_error_mark = 'i';

/// The first sample whose counters differ, for the message.
std::string first_difference(RunStatistics const& run, std::vector<SampleCounters> const& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!(counters_from(run.samples[i].counters) == expected[i]))
            return fmt::format("sample {}", i);
    return {};
}

Estimate sum(Estimate const& a, Estimate const& b) { return {a.low + b.low, a.typical + b.typical, a.high + b.high}; }

/// For the way from one process to another: every number comes back as it was.
std::string text_of(Estimate const& estimate) {
    return fmt::format(" {} {} {}", estimate.low, estimate.typical, estimate.high);
}

std::string cost_text(RunStatistics const& run) {
    RunPower const power = power_of(run);
    return std::to_string(run.total_cycles) + text_of(power.energy_mj) + text_of(sum(power.static_w, power.ps_w));
}

IterationCost cost_from(std::string const& text) {
    IterationCost cost;
    std::istringstream numbers(text);
    numbers >> cost.cycles;
    for (Estimate* const estimate : {&cost.energy_mj, &cost.idle_w})
        numbers >> estimate->low >> estimate->typical >> estimate->high;
    return cost;
}

/// What one process does: an iteration of all.
class IterationSimulation {
  public:
    IterationSimulation(LoadedConfig const& loaded, Stimulus const& observed,
                        std::optional<IterationRecording> const& recording)
        : loaded_(loaded), observed_(observed), recording_(recording) {}

    std::string simulated(ScoredPoses const& iteration, std::size_t number) const {
        try {
            return simulated_and_recorded(iteration, recording_ && recording_->iteration == number);
        } catch (InputError const& error) {
            return input_error_mark + std::string(error.what());
        }
    }

  private:
    std::string simulated_and_recorded(ScoredPoses const& iteration, bool is_recorded) const {
        Stimulus stimulus = observed_;
        workload::set_poses(iteration.poses, stimulus);
        Machine const machine = machine_of(loaded_.config);
        auto const events = io::optional_output_file(is_recorded ? recording_->events : "");
        replay::RecordedRun recorded;
        SimulationOptions options;
        options.recorded = events ? &recorded : nullptr;
        if (is_recorded)
            options.recordings = make_recordings(recording_->request, machine, stimulus.samples.size());
        RunStatistics const run =
            simulate(accelerator_of(loaded_.config), stimulus, loaded_.config.simulation.engine, options);
        if (run.deadlocked())
            return deadlock_mark + report::deadlock_report(run);
        if (events)
            write_events(*events, loaded_, recorded, run);
        std::string const difference = first_difference(run, iteration.counters);
        return difference.empty() ? cost_mark + cost_text(run) : difference_mark + difference;
    }

    LoadedConfig const& loaded_;
    Stimulus const& observed_;
    std::optional<IterationRecording> const& recording_;
};

std::vector<processes::Outcome> simulate_all(IterationSimulation const& simulation,
                                             std::vector<ScoredPoses> const& iterations, std::size_t jobs) {
    std::vector<processes::Task> tasks;
    for (std::size_t i = 0; i < iterations.size(); ++i)
        tasks.push_back({[&simulation, &iterations, i] { return simulation.simulated(iterations[i], i); }});
    processes::SignalWatch const watch;
    ProgressLine progress("iterations simulated");
    return processes::run_all(tasks, jobs, watch,
                              [&progress](std::size_t done, std::size_t all) { progress.show(done, all); });
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

IterationCosts simulate_iterations(LoadedConfig const& loaded, Stimulus const& observed,
                                   std::vector<ScoredPoses> const& iterations,
                                   std::optional<IterationRecording> const& recording, std::size_t jobs) {
    if (recording)
        announce_waveform(*recording, loaded, observed, iterations.at(recording->iteration));
    IterationCosts result;
    IterationSimulation const simulation(loaded, observed, recording);
    std::vector<processes::Outcome> const outcomes = simulate_all(simulation, iterations, jobs);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (outcomes[i].kind != processes::Outcome::Kind::done)
            throw HostError(fmt::format(
                "iteration {}: the simulation crashed, failed or took more than an hour, expected a result", i));
        std::string const& output = outcomes[i].output;
        if (output.front() == input_error_mark)
            throw InputError(output.substr(1));
        if (output.front() == difference_mark)
            throw std::runtime_error(
                fmt::format("iteration {}: the model's counters of {} are not the untimed ones", i, output.substr(1)));
        if (output.front() == deadlock_mark) {
            result.deadlock = output.substr(1);
            return result;
        }
        result.costs.push_back(cost_from(output.substr(1)));
    }
    return result;
}

}  // namespace faster
