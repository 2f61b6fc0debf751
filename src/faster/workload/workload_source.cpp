#include "faster/workload/workload_source.hpp"

#include <fmt/format.h>

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

std::string unset_camera_warning(LoadedConfig const& loaded) {
    WorkloadConfig const& workload = workload_of(loaded.config);
    bool is_set = workload.scene.depth_image.empty();
    for (char const* const key : {"fx", "fy", "cx", "cy"})
        is_set |= loaded.origins.is_explicit(std::string("workload.camera.") + key);
    if (is_set)
        return {};
    Camera const& camera = workload.camera;
    return fmt::format(
        "workload.scene.depth_image = {}: no key says which camera took it, and the default one is taken (fx {:g}, fy "
        "{:g}, cx {:g}, cy {:g}); expected workload.camera.fx, fy, cx and cy",
        workload.scene.depth_image, camera.fx, camera.fy, camera.cx, camera.cy);
}

std::vector<std::string> stimulus_warnings(Stimulus const& stimulus, LoadedConfig const& loaded) {
    WorkloadConfig const& config = workload_of(loaded.config);
    if (!config.trace.empty())
        return {};
    std::vector<std::string> warnings =
        workload::input_warnings(config, stimulus.posed.mesh, stimulus.posed.poses, stimulus.fraction);
    if (std::string const unset = unset_camera_warning(loaded); !unset.empty())
        warnings.push_back(unset);
    return warnings;
}

}  // namespace faster
