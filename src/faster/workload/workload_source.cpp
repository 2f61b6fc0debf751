#include "faster/workload/workload_source.hpp"

#include "faster/config/adopt_trace.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "faster/workload/files/trace.hpp"
#include "faster/workload/input_warnings.hpp"

namespace faster {

Stimulus load_stimulus(LoadedConfig& loaded) {
    WorkloadConfig const& config = workload_of(loaded.config);
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
    if (config.trace.empty()) {
        Stimulus stimulus = workload::build_stimulus(config, accelerator.window, accelerator.fraction_bits);
        if (!config.samples.poses.empty())
            adopt_poses(loaded, stimulus.samples.size());
        return stimulus;
    }
    Stimulus stimulus = files::read_trace(config.trace);
    adopt_trace(loaded, stimulus.width, stimulus.height, stimulus.window, stimulus.fraction, stimulus.samples.size());
    return stimulus;
}

std::vector<std::string> stimulus_warnings(Stimulus const& stimulus, WorkloadConfig const& config) {
    if (!config.trace.empty())
        return {};
    return workload::input_warnings(config, stimulus.posed.mesh, stimulus.posed.poses, stimulus.fraction);
}

}  // namespace faster
