#include "poses/commands/estimate_scene.hpp"

#include <fmt/format.h>
#include <limits>

#include "dataflow/base/input_error.hpp"
#include "dataflow/commands/say.hpp"
#include "dataflow/run/config/config_sources.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "faster/workload/object_mesh.hpp"
#include "faster/workload/object_pose.hpp"
#include "poses/bop/detections.hpp"
#include "poses/bop/read_dataset.hpp"

namespace faster {

namespace {

/// Files of a configuration serve datasets and scenes of one's own, so only who asks on the command line is told.
bool is_told_by_datasets(std::string const& key) {
    if (key == "workload.scene.downscale" || key == "estimator.box.confidence")
        return false;
    for (char const* const section : {"estimator.box.", "workload.object", "workload.pose.", "workload.camera.",
                                      "workload.scene.", "workload.mesh_files."})
        if (key.rfind(section, 0) == 0)
            return true;
    return false;
}

}  // namespace

void require_estimable(LoadedConfig const& loaded) {
    WorkloadConfig const& workload = workload_of(loaded.config);
    if (!workload.trace.empty())
        throw InputError(
            complaint(loaded, "workload.trace", "none: estimate moves a mesh, which a trace does not have"));
    if (!workload.samples.poses.empty())
        throw InputError(complaint(loaded, "workload.samples.poses", "none: estimate draws its samples itself"));
    if (workload.samples.count == 0)
        throw InputError(complaint(loaded, "workload.samples.count", "at least 1: estimate scores samples"));
}

std::vector<std::string> idle_keys_of_datasets(LoadedConfig const& loaded) {
    std::vector<std::string> warnings;
    for (auto const& [key, origin] : loaded.origins.all())
        if (origin.source == KeySource::command_line && is_told_by_datasets(key))
            warnings.push_back(origin.place + ": has no effect, as a dataset tells it itself");
    return warnings;
}

namespace {

/// A rendered scene has the object at its pose, configured or not; in a recorded depth image it is wherever it was.
bool is_pose_known(LoadedConfig const& loaded) {
    return workload_of(loaded.config).scene.depth_image.empty() ||
           loaded.origins.is_explicit("workload.pose.translation_m") ||
           loaded.origins.is_explicit("workload.pose.rotation_deg");
}

/// The configured box, or the one around the object. An object that is not in the image, or nobody knows where, has
/// none.
std::vector<DetectionConfig> boxes_of(LoadedConfig const& loaded, estimation::Scene const& scene) {
    DetectionConfig box = estimator_of(loaded.config).box;
    if (box.width == 0) {
        if (scene.truths.empty())
            return {};
        double const confidence = box.confidence;
        box = estimation::box_around(scene.observed.posed.mesh.vertices, scene.truths.front().pose,
                                     scene.observed.posed.camera);
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
    require_estimable(loaded);
    WorkloadConfig const& workload = workload_of(loaded.config);
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
    estimation::Scene scene;
    scene.observed = workload::build_observation(workload, accelerator.window, accelerator.fraction_bits);
    estimation::centre_mesh(scene);
    if (is_pose_known(loaded))
        scene.truths = {{scene.centred(workload::configured_pose(workload.target)), std::nullopt}};
    scene.boxes = boxes_of(loaded, scene);
    return scene;
}

namespace {

bop::DatasetImage const& image_of(bop::Dataset const& dataset, BopRequest const& request) {
    bop::DatasetImage const* const image = dataset.find(request.image());
    if (image == nullptr)
        throw InputError(fmt::format(
            "--scene {} --image {}: no such image in {}, expected one of its {} images{}", request.image().scene_id,
            request.image().im_id, request.folder, dataset.images.size(),
            dataset.images.empty() ? ""
                                   : fmt::format(", such as --scene {} --image {}", dataset.images.front().id.scene_id,
                                                 dataset.images.front().id.im_id)));
    return *image;
}

/// What is to be found of the object in the image: as many as the targets say, or all.
bop::Target target_of(bop::Dataset const& dataset, bop::ImageId image, int obj_id) {
    for (bop::Target const& target : dataset.targets)
        if (target.image == image && target.obj_id == obj_id)
            return target;
    return {image, obj_id, std::numeric_limits<int>::max()};
}

/// Of what is visible, or of all of it, or else what the pose says.
bop::ImageBox annotated_box(bop::GroundTruth const& object, Mesh const& mesh, Camera const& camera) {
    if (object.visible_box)
        return *object.visible_box;
    return object.box ? *object.box : bop::projected_box(mesh, object.pose, camera);
}

/// All detections of the object in the image, or the annotated boxes of what is to be found.
std::vector<bop::Detection> boxes_in(bop::DatasetImage const& image, poses::Truths const& truths, Mesh const& mesh,
                                     Camera const& camera, BopRequest const& request, double confidence,
                                     std::vector<std::string>& warnings) {
    if (request.detections.empty())
        return annotated_boxes(
            truths, image.id, camera, [&](int) -> Mesh const& { return mesh; }, confidence);
    std::vector<bop::Detection> boxes;
    for (bop::Detection const& detection : bop::read_detections(request.detections, warnings))
        if (detection.obj_id == request.object() && detection.image == image.id)
            boxes.push_back(bop::sound(detection));
    return boxes;
}

void require_overlap(bop::ImageBox const& box, Camera const& camera, BopRequest const& request) {
    if (overlaps(box, camera))
        return;
    throw InputError(fmt::format("{}: box [{}, {}, {}, {}], expected one that overlaps the image of {} x {} pixels",
                                 request.detections.empty() ? request.folder : request.detections, box.left, box.top,
                                 box.width, box.height, camera.width, camera.height));
}

/// What estimate looks at, without boxes and truth.
estimation::Scene observed_scene(LoadedConfig const& loaded, Mesh const& mesh, bop::Observation const& seen) {
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
    WorkloadConfig const& workload = workload_of(loaded.config);
    int const n = workload.scene.downscale;
    estimation::Scene scene;
    scene.observed =
        workload::observed_stimulus(mesh, workload::downscaled(seen.depth, n), workload::downscaled(seen.camera, n),
                                    workload, accelerator.window, accelerator.fraction_bits);
    estimation::centre_mesh(scene);
    return scene;
}

/// As `evaluate` judges: by the vertices of the mesh that is for it.
void add_judged_points(estimation::Scene& scene, bop::ObjectModel const& model, Mesh const& mesh) {
    std::vector<std::string> told_by_evaluate;
    scene.judged_points =
        model.judged_mesh.empty() ? mesh.vertices : bop::load_judged_model(model, told_by_evaluate).vertices;
    for (Eigen::Vector3d& point : scene.judged_points)
        point += scene.own_origin;
}

void add_truths_and_boxes(estimation::Scene& scene, poses::Truths const& truths,
                          std::vector<bop::Detection> const& boxes, int downscale) {
    for (bop::GroundTruth const* const object : truths)
        scene.truths.push_back({scene.centred(object->pose), object->visible_share});
    for (bop::Detection const& detection : boxes) {
        bop::ImageBox const& box = detection.box;
        scene.boxes.push_back({box.left / downscale, box.top / downscale, box.width / downscale, box.height / downscale,
                               detection.score});
    }
}

}  // namespace

std::optional<double> unit_of_models(std::string const& name) {
    return name.empty() ? std::nullopt : std::optional(name == "m" ? 1.0 : 1e-3);
}

bop::Dataset dataset_of(BopRequest const& request) {
    bop::DatasetOptions options;
    options.split = request.split;
    options.unit_m = unit_of_models(request.models_in);
    return bop::read_dataset(request.folder, options);
}

bool overlaps(bop::ImageBox const& box, Camera const& camera) {
    return estimation::overlaps({box.left, box.top, box.width, box.height, 0}, camera.width, camera.height);
}

std::vector<bop::Detection> annotated_boxes(poses::Truths const& objects, bop::ImageId image, Camera const& camera,
                                            std::function<Mesh const&(int obj_id)> const& mesh, double confidence) {
    std::vector<bop::Detection> boxes;
    for (bop::GroundTruth const* const object : objects)
        if (!object->is_hidden())
            boxes.push_back(
                {image, object->obj_id, annotated_box(*object, mesh(object->obj_id), camera), confidence, -1});
    return boxes;
}

estimation::Scene dataset_scene(LoadedConfig const& loaded, bop::Dataset const& dataset, bop::Target const& target,
                                std::vector<bop::Detection> const& boxes) {
    std::vector<std::string> told_before;
    bop::ObjectModel const& model = bop::model_of(dataset, target.obj_id, dataset.place_of_targets());
    Mesh const mesh = bop::load_model(model, told_before);
    estimation::Scene scene = observed_scene(loaded, mesh, bop::load_observation(*dataset.find(target.image)));
    add_judged_points(scene, model, mesh);
    add_truths_and_boxes(scene, poses::most_visible(dataset, target), boxes,
                         workload_of(loaded.config).scene.downscale);
    return scene;
}

estimation::Scene bop_scene(LoadedConfig const& loaded, BopRequest const& request) {
    require_estimable(loaded);
    say_warnings(idle_keys_of_datasets(loaded));
    bop::Dataset const dataset = dataset_of(request);
    std::vector<std::string> warnings = dataset.warnings;
    bop::DatasetImage const& image = image_of(dataset, request);
    bop::ObjectModel const& model = bop::model_of(dataset, request.object(), "--object");
    Mesh const mesh = bop::load_model(model, warnings);
    bop::Observation const seen = bop::load_observation(image);
    bop::tell_of_depths(seen, image, warnings);
    poses::Truths const truths = poses::most_visible(dataset, target_of(dataset, image.id, request.object()));
    std::vector<bop::Detection> const boxes =
        boxes_in(image, truths, mesh, seen.camera, request, estimator_of(loaded.config).box.confidence, warnings);
    if (boxes.empty())
        warnings.push_back(
            fmt::format("{}: has no box of object {} in image {} of scene {}, which is looked for in the whole image",
                        request.detections.empty() ? request.folder : request.detections, request.object(),
                        image.id.im_id, image.id.scene_id));
    say_warnings(warnings);
    for (bop::Detection const& detection : boxes)
        require_overlap(detection.box, seen.camera, request);
    estimation::Scene scene = observed_scene(loaded, mesh, seen);
    if (std::string const left_out = workload::duplicates_warning(scene.observed.posed.mesh, model.mesh.string());
        !left_out.empty())
        say_warnings({left_out});
    add_judged_points(scene, model, mesh);
    add_truths_and_boxes(scene, truths, boxes, workload_of(loaded.config).scene.downscale);
    return scene;
}

}  // namespace faster
