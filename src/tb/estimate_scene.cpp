#include "tb/estimate_scene.hpp"

#include <fmt/format.h>

#include "faster/faster_config.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/config/config_sources.hpp"
#include "workload/build_stimulus.hpp"
#include "workload/object_pose.hpp"

namespace faster {

namespace {

/// A trace has triangles, but no mesh to move.
void require_mesh_and_samples(LoadedConfig const& loaded) {
    if (!workload_of(loaded.config).trace.empty())
        throw InputError(
            complaint(loaded, "workload.trace", "none: estimate moves a mesh, which a trace does not have"));
    if (workload_of(loaded.config).samples.count == 0)
        throw InputError(complaint(loaded, "workload.samples.count", "at least 1: estimate scores samples"));
}

/// The configured box, or the one around the object. An object that is not in the image has none.
std::vector<DetectionConfig> boxes_of(LoadedConfig const& loaded, estimation::Scene const& scene) {
    DetectionConfig box = estimator_of(loaded.config).box;
    if (box.width == 0) {
        double const confidence = box.confidence;
        box = estimation::box_around(scene.observed.posed.mesh, *scene.truth, scene.observed.posed.camera);
        box.confidence = confidence;
        return box.width > 0 && box.height > 0 ? std::vector<DetectionConfig>{box} : std::vector<DetectionConfig>{};
    }
    if (box.height == 0)
        box.height = box.width;
    if (!estimation::overlaps(box, scene.observed.width, scene.observed.height))
        throw InputError(complaint(
            loaded,
            box.left + box.width <= 0 || box.left >= scene.observed.width ? "estimator.box.left" : "estimator.box.top",
            fmt::format("a box that overlaps the image of {} x {} pixels", scene.observed.width,
                        scene.observed.height)));
    return {box};
}

}  // namespace

estimation::Scene configured_scene(LoadedConfig const& loaded) {
    require_mesh_and_samples(loaded);
    WorkloadConfig const& workload = workload_of(loaded.config);
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
    estimation::Scene scene;
    scene.observed = workload::build_observation(workload, accelerator.window, accelerator.fraction_bits);
    scene.size = estimation::size_of(scene.observed.posed.mesh);
    scene.truth = workload::configured_pose(workload.target);
    scene.boxes = boxes_of(loaded, scene);
    return scene;
}

}  // namespace faster
