#include "tb/timed_iterations.hpp"

#include <fmt/format.h>
#include <stdexcept>

#include "faster/faster_config.hpp"
#include "kernel/base/process_pool.hpp"
#include "kernel/report/text_report.hpp"
#include "modules/faster_simulation.hpp"
#include "tool/progress_line.hpp"
#include "workload/build_stimulus.hpp"

namespace faster {

namespace {

constexpr double time_limit_s = 3600;
constexpr char cycles_mark = 'c';
constexpr char deadlock_mark = 'd';
constexpr char difference_mark = 'x';

/// The first sample whose counters differ, for the message.
std::string first_difference(RunStatistics const& run, std::vector<SampleCounters> const& expected) {
    for (std::size_t i = 0; i < expected.size(); ++i)
        if (!(counters_from(run.samples[i].counters) == expected[i]))
            return fmt::format("sample {}", i);
    return {};
}

std::string simulated(RunConfig const& config, Stimulus const& observed, ScoredPoses const& iteration) {
    Stimulus stimulus = observed;
    workload::set_poses(iteration.poses, stimulus);
    RunStatistics const run = simulate(accelerator_of(config), stimulus, config.simulation.engine);
    if (run.deadlocked())
        return deadlock_mark + report::deadlock_report(run);
    std::string const difference = first_difference(run, iteration.counters);
    return difference.empty() ? cycles_mark + std::to_string(run.total_cycles) : difference_mark + difference;
}

std::vector<processes::Outcome> simulate_all(RunConfig const& config, Stimulus const& observed,
                                             std::vector<ScoredPoses> const& iterations, std::size_t jobs) {
    std::vector<processes::Task> tasks;
    for (ScoredPoses const& iteration : iterations)
        tasks.push_back({[&] { return simulated(config, observed, iteration); }, time_limit_s});
    processes::SignalWatch const watch;
    ProgressLine progress("iterations simulated");
    return processes::run_all(tasks, jobs, watch,
                              [&progress](std::size_t done, std::size_t all) { progress.show(done, all); });
}

}  // namespace

IterationCycles simulate_iterations(RunConfig const& config, Stimulus const& observed,
                                    std::vector<ScoredPoses> const& iterations, std::size_t jobs) {
    IterationCycles result;
    std::vector<processes::Outcome> const outcomes = simulate_all(config, observed, iterations, jobs);
    for (std::size_t i = 0; i < outcomes.size(); ++i) {
        if (outcomes[i].kind != processes::Outcome::Kind::done)
            throw std::runtime_error(
                fmt::format("iteration {}: the simulation crashed, failed or took more than an hour", i));
        std::string const& output = outcomes[i].output;
        if (output.front() == difference_mark)
            throw std::runtime_error(
                fmt::format("iteration {}: the model's counters of {} are not the untimed ones", i, output.substr(1)));
        if (output.front() == deadlock_mark) {
            result.deadlock = output.substr(1);
            return result;
        }
        result.cycles.push_back(std::stoull(output.substr(1)));
    }
    return result;
}

}  // namespace faster
