#include "poses/commands/estimate_size.hpp"

#include "dataflow/commands/work_size.hpp"
#include "dataflow/run/config/design.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/workload_iterations.hpp"

namespace faster {

namespace {

/// Measured with shipped configurations.
constexpr double pixels_by_grip_per_s = 3e8;
constexpr double iterations_by_reference_per_s = 2e8;
constexpr double iterations_by_counters_per_s = 1e9;  ///< the scorer that only counts

}  // namespace

double seconds_by_grip(Stimulus const& observed, std::size_t poses) {
    return static_cast<double>(poses) * static_cast<double>(observed.width) * static_cast<double>(observed.height) /
           pixels_by_grip_per_s;
}

double seconds_by_reference(LoopIterations const& iterations) {
    return iterations.all() / iterations_by_reference_per_s;
}

double seconds_of_estimate(RunConfig const& config, Stimulus const& observed, bool timed) {
    EstimatorConfig const& estimator = estimator_of(config);
    auto const iterations = static_cast<double>(estimator.all_iterations());
    std::size_t const samples = workload_of(config).samples.count;
    if (estimator.backend == EstimatorBackend::grip)
        return iterations * seconds_by_grip(observed, samples);
    LoopIterations const loops = loop_iterations(observed, samples);
    double const simulation = timed ? size_of_run(config, machine_of(config), samples, loops).seconds : 0;
    return iterations * (loops.all() / iterations_by_counters_per_s + simulation);
}

}  // namespace faster
