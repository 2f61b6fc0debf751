#include "dataflow/commands/run_size.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <optional>
#include <sstream>

#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/process_pool.hpp"
#include "dataflow/commands/work_size.hpp"

namespace dataflow {

namespace {

constexpr std::size_t fewest_samples = 10;  ///< of a run that is timed
constexpr double surely_timed_s = 0.2;      ///< beside which making the cores takes no time
constexpr double longest_trial_s = 60;

/// The first samples of a run.
struct TimedSamples {
    std::uint64_t samples = 0;
    double seconds = 0;
};

/// None if it fails or gets stuck, as the run will.
std::optional<TimedSamples> time_samples(RunConfig const& config, Workload& workload, std::size_t samples) {
    processes::Task task;
    task.time_limit_s = longest_trial_s;
    task.work = [&] {
        std::uint64_t done = 0;
        SimulationOptions options;
        options.at_any_size = true;
        options.most_samples = samples;
        options.progress = [&done](std::uint64_t count) { done = count; };
        auto const start = HostClock::now();
        simulate(config, workload, options);
        return fmt::format("{} {}", done, seconds_since(start));
    };
    processes::SignalWatch const watch;
    processes::Outcome const outcome = processes::run_all({task}, 1, watch).front();
    if (outcome.kind == processes::Outcome::Kind::timed_out)
        return TimedSamples{1, longest_trial_s};
    TimedSamples trial;
    std::istringstream words(outcome.output);
    return words >> trial.samples >> trial.seconds && trial.samples > 0 ? std::optional(trial) : std::nullopt;
}

/// Of the whole run. The more samples a long one has, the more are tried.
double timed_seconds(RunConfig const& config, Workload& workload) {
    double seconds = 0;
    for (std::size_t samples = 1; samples * fewest_samples <= workload.samples(); samples *= 10) {
        std::optional<TimedSamples> const trial = time_samples(config, workload, samples);
        if (!trial)
            return 0;
        seconds = trial->seconds * static_cast<double>(workload.samples()) / static_cast<double>(trial->samples);
        if (seconds < announced_s || trial->seconds > surely_timed_s)
            break;
    }
    return seconds;
}

}  // namespace

void announce_run(RunConfig const& config, Machine const& machine, Workload& workload, bool force) {
    WorkSize size = size_of_run(config, machine, workload);
    if (!force)
        require_memory(size);
    if (workload.iterations().all() == 0)
        size.seconds = timed_seconds(config, workload);
    announce(size, force);
}

}  // namespace dataflow
