#include "tb/estimate_scene.hpp"

#include <fmt/format.h>

#include "faster/faster_config.hpp"
#include "kernel/base/input_error.hpp"
#include "kernel/config/config_sources.hpp"
#include "workload/bop/detections.hpp"
#include "workload/bop/read_dataset.hpp"
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
        box = estimation::box_around(scene.observed.posed.mesh.vertices, *scene.truth, scene.observed.posed.camera);
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
    estimation::centre_mesh(scene);
    scene.truth = scene.centred(workload::configured_pose(workload.target));
    scene.boxes = boxes_of(loaded, scene);
    return scene;
}

namespace {

bop::DatasetImage const& image_of(bop::Dataset const& dataset, BopRequest const& request) {
    bop::DatasetImage const* const image = dataset.find({request.scene_id, request.im_id});
    if (image == nullptr)
        throw InputError(fmt::format("--scene {} --image {}: no such image in {}, expected one of its {} images",
                                     request.scene_id, request.im_id, request.folder, dataset.images.size()));
    return *image;
}

DetectionConfig with_confidence(bop::ImageBox const& box, double confidence) {
    return {box.left, box.top, box.width, box.height, confidence};
}

/// The annotation of what is visible, or of all of it, or else what the pose says.
bop::ImageBox annotated_box(bop::GroundTruth const& object, Mesh const& mesh, Camera const& camera) {
    if (object.visible_box)
        return *object.visible_box;
    return object.box ? *object.box : bop::projected_box(mesh, object.pose, camera);
}

std::vector<DetectionConfig> detected_boxes(BopRequest const& request) {
    std::vector<DetectionConfig> boxes;
    for (bop::Detection const& detection : bop::read_detections(request.detections))
        if (detection.obj_id == request.obj_id && detection.image == bop::ImageId{request.scene_id, request.im_id})
            boxes.push_back(with_confidence(detection.box, detection.score));
    return boxes;
}

void require_overlap(DetectionConfig const& box, Camera const& camera, BopRequest const& request) {
    if (estimation::overlaps(box, camera.width, camera.height))
        return;
    throw InputError(fmt::format("{}: box [{}, {}, {}, {}], expected one that overlaps the image of {} x {} pixels",
                                 request.detections.empty() ? request.folder : request.detections, box.left, box.top,
                                 box.width, box.height, camera.width, camera.height));
}

}  // namespace

estimation::Scene bop_scene(LoadedConfig const& loaded, BopRequest const& request) {
    require_mesh_and_samples(loaded);
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
    WorkloadConfig const& workload = workload_of(loaded.config);
    bop::Dataset const dataset = bop::read_dataset(request.folder);
    bop::DatasetImage const& image = image_of(dataset, request);
    Mesh const mesh = bop::load_model(bop::model_of(dataset, request.obj_id, "--object"));
    bop::Observation const seen = bop::load_observation(image);
    int const n = workload.scene.downscale;
    estimation::Scene scene;
    scene.observed =
        workload::observed_stimulus(mesh, workload::downscaled(seen.depth, n), workload::downscaled(seen.camera, n),
                                    workload, accelerator.window, accelerator.fraction_bits);
    estimation::centre_mesh(scene);
    double const confidence = estimator_of(loaded.config).box.confidence;
    for (bop::GroundTruth const& object : image.objects) {
        if (object.obj_id != request.obj_id)
            continue;
        if (!scene.truth)
            scene.truth = scene.centred(object.pose);
        if (request.detections.empty())
            scene.boxes.push_back(with_confidence(annotated_box(object, mesh, seen.camera), confidence));
    }
    if (!request.detections.empty())
        scene.boxes = detected_boxes(request);
    for (DetectionConfig& box : scene.boxes) {
        require_overlap(box, seen.camera, request);
        box = {box.left / n, box.top / n, box.width / n, box.height / n, box.confidence};
    }
    return scene;
}

}  // namespace faster
