#pragma once
#include <memory>

#include "dataflow/run/config/run_config.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/config/estimator_config.hpp"
#include "faster/config/workload_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What the keys of FASTER say: `accelerator.*`, `workload.*`, `estimator.*` and `host.*`.
struct FasterConfig final : DesignConfig {
    AcceleratorConfig accelerator;
    WorkloadConfig workload;
    EstimatorConfig estimator;
    HostConfig host;

    std::unique_ptr<DesignConfig> clone() const override { return std::make_unique<FasterConfig>(*this); }
    MachineSettings& machine() override { return accelerator; }
    MachineSettings const& machine() const override { return accelerator; }
};

/// Parts of a whole configuration.
inline AcceleratorConfig& accelerator_of(RunConfig& config) { return config.as<FasterConfig>().accelerator; }
inline AcceleratorConfig const& accelerator_of(RunConfig const& config) {
    return config.as<FasterConfig>().accelerator;
}
inline WorkloadConfig& workload_of(RunConfig& config) { return config.as<FasterConfig>().workload; }
inline WorkloadConfig const& workload_of(RunConfig const& config) { return config.as<FasterConfig>().workload; }
inline EstimatorConfig const& estimator_of(RunConfig const& config) { return config.as<FasterConfig>().estimator; }
inline HostConfig const& host_of(RunConfig const& config) { return config.as<FasterConfig>().host; }

}  // namespace faster
