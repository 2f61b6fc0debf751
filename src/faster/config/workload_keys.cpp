#include <array>
#include <limits>

#include "dataflow/run/config/key_builders.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/config/faster_keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

using Make = KeyMaker<FasterConfig>;

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr NumberRange positive{0, unlimited, true};
constexpr NumberRange not_negative{0, unlimited};
constexpr NumberRange probability{0, 1};
constexpr IntegerRange image_side{1, 4096};
constexpr IntegerRange any_seed{};

constexpr char const* noise_source = "Nguyen et al., 3DIMPVT 2012";

ObjectWords class_or_mesh() { return {"an object class or the path of a mesh file", "class or path"}; }

std::vector<ItemField> fields_of_scene_object() {
    SceneObjectConfig const defaults;
    return {{{"object", "", "Class or mesh file, as workload.object; has to be given.", "this project"},
             KeyKind::object,
             true,
             defaults.object,
             class_or_mesh()},
            {{"translation_m", "m", "Origin of the object in the camera frame; has to be given.", "this project"},
             KeyKind::vector,
             true,
             defaults.translation_m},
            {{"rotation_deg", "degrees", "Rotation about the camera's x, then y, then z axis.", "this project"},
             KeyKind::vector,
             false,
             defaults.rotation_deg}};
}

/// In the order of fields_of_scene_object().
ItemValue item_of(SceneObjectConfig const& object) {
    return {
        {{"object", object.object}, {"translation_m", object.translation_m}, {"rotation_deg", object.rotation_deg}}};
}

SceneObjectConfig scene_object(ItemValue const& item) {
    using Numbers = std::array<double, 3>;
    return {std::get<std::string>(item.fields[0].second), std::get<Numbers>(item.fields[1].second),
            std::get<Numbers>(item.fields[2].second)};
}

Key scene_objects_key() {
    Key key;
    key.text = {"workload.scene.objects", "", "Other objects of a rendered scene, beside or before the one looked for.",
                "this project"};
    key.kind = KeyKind::items;
    key.fields = fields_of_scene_object();
    key.read = [](RunConfig const& config) {
        std::vector<ItemValue> items;
        for (SceneObjectConfig const& object : workload_of(config).scene.objects)
            items.push_back(item_of(object));
        return KeyValue{items};
    };
    key.write = [](RunConfig& config, KeyValue const& value) {
        std::vector<SceneObjectConfig>& objects = workload_of(config).scene.objects;
        objects.clear();
        for (ItemValue const& item : std::get<std::vector<ItemValue>>(value))
            objects.push_back(scene_object(item));
    };
    return key;
}

void add_target_keys(Keys& keys) {
    auto workload = key_section(keys, "workload", &FasterConfig::workload);
    auto target = key_section(keys, "workload", &FasterConfig::workload, &WorkloadConfig::target);
    target.of_kind("object", "",
                   "The object whose pose is estimated: a built-in YCB class, or a mesh file (obj, ply, stl, "
                   "off; has a / or . in its name).",
                   "thesis 6", KeyKind::object, &SceneObjectConfig::object);
    keys.back().words = class_or_mesh();
    workload.integer("max_triangles", "triangles",
                     "The mesh is simplified to about this many triangles; 0 keeps it as it is.", "this project",
                     {0, 10'000'000}, &WorkloadConfig::max_triangles);
    workload.of_kind("trace", "", "Folder of a stimulus trace that replaces the rest of the workload; empty for none.",
                     "docs/formats.md", KeyKind::path, &WorkloadConfig::trace);
    target.of_kind("pose.translation_m", "m", "Origin of the object in the camera frame.", "this project",
                   KeyKind::vector, &SceneObjectConfig::translation_m);
    target.of_kind("pose.rotation_deg", "degrees", "Rotation about the camera's x, then y, then z axis (R = Rz Ry Rx).",
                   "this project", KeyKind::vector, &SceneObjectConfig::rotation_deg);
}

void add_mesh_file_keys(Keys& keys) {
    auto mesh_files = key_section(keys, "workload.mesh_files", &FasterConfig::workload, &WorkloadConfig::mesh_files);
    mesh_files.number("scale", "m",
                      "Metres per unit of mesh files: 0.001 for millimetres. Built-in classes are in metres.",
                      "this project", positive, &MeshFilesConfig::scale);
    mesh_files
        .number("time_limit_s", "s", "How long reading a mesh file may take.", "this project", {0, 86'400, true},
                &MeshFilesConfig::time_limit_s)
        .decides_figures = false;
    mesh_files
        .integer("memory_limit_mib", "MiB", "How much memory it may take.", "this project", {1, 1'048'576},
                 &MeshFilesConfig::memory_limit_mib)
        .decides_figures = false;
    mesh_files
        .integer("file_limit_mib", "MiB", "How long a mesh file may be.", "this project", {1, 1'048'576},
                 &MeshFilesConfig::file_limit_mib)
        .decides_figures = false;
}

void add_camera_keys(Keys& keys) {
    auto camera = key_section(keys, "workload.camera", &FasterConfig::workload, &WorkloadConfig::camera);
    camera.integer("width", "px", "Width of the image.", "this project", image_side, &Camera::width);
    camera.integer("height", "px", "Height of the image.", "this project", image_side, &Camera::height);
    camera.number("fx", "px", "Focal length along a row.", "this project", positive, &Camera::fx);
    camera.number("fy", "px", "Focal length along a column.", "this project", positive, &Camera::fy);
    camera.number("cx", "px", "Column of the optical axis.", "this project", {}, &Camera::cx);
    camera.number("cy", "px", "Row of the optical axis.", "this project", {}, &Camera::cy);
}

void add_depth_image_keys(Keys& keys) {
    auto scene = key_section(keys, "workload.scene", &FasterConfig::workload, &WorkloadConfig::scene);
    scene.of_kind("depth_image", "", "16-bit greyscale PNG or TIFF of the observed scene; empty to render one.",
                  "this project", KeyKind::path, &SceneConfig::depth_image);
    scene.number("depth_unit_m", "m", "Metres per unit of the depth image.", "this project", positive,
                 &SceneConfig::depth_unit_m);
    scene.integer("downscale", "", "Every n-th pixel of the scene is kept, and the camera divided by n.",
                  "this project", {1, 64}, &SceneConfig::downscale);
}

void add_rendered_scene_keys(Keys& keys) {
    auto scene = key_section(keys, "workload.scene", &FasterConfig::workload, &WorkloadConfig::scene);
    scene.boolean("table", "", "Whether a rendered scene has a table.", "this project", &SceneConfig::table);
    scene.number("table_height_m", "m", "Camera y (down) of the table at x = 0 and the object's z.", "this project", {},
                 &SceneConfig::table_height_m);
    scene.number("table_tilt_deg", "degrees", "Angle by which the camera looks down on the table.", "this project",
                 {0, 90}, &SceneConfig::table_tilt_deg);
    keys.push_back(scene_objects_key());
    scene.integer("seed", "", "Seed of the sensor noise.", "this project", any_seed, &SceneConfig::seed);
}

void add_noise_keys(Keys& keys) {
    auto noise =
        key_section(keys, "workload.scene.noise", &FasterConfig::workload, &WorkloadConfig::scene, &SceneConfig::noise);
    noise.boolean("enabled", "", "Whether a rendered scene gets sensor noise.", noise_source, &NoiseConfig::enabled);
    noise.number("axial_base_m", "m", "Standard deviation of depth at axial_offset_m.", noise_source, not_negative,
                 &NoiseConfig::axial_base_m);
    noise.number("axial_quadratic", "1/m", "Growth of the standard deviation with the square of z - axial_offset_m.",
                 noise_source, not_negative, &NoiseConfig::axial_quadratic);
    noise.number("axial_offset_m", "m", "Depth of least noise.", noise_source, not_negative,
                 &NoiseConfig::axial_offset_m);
    noise.number("edge_dropout", "probability", "Chance of a missing reading at a depth edge.", "this project",
                 probability, &NoiseConfig::edge_dropout);
    noise.number("edge_step_m", "m", "Depth difference of neighbouring pixels that makes a depth edge.", "this project",
                 positive, &NoiseConfig::edge_step_m);
    noise.number("random_dropout", "probability", "Chance of a missing reading anywhere.", "this project", probability,
                 &NoiseConfig::random_dropout);
}

void add_observed_edges_keys(Keys& keys) {
    auto observed_edges =
        key_section(keys, "workload.observed_edges", &FasterConfig::workload, &WorkloadConfig::observed_edges);
    observed_edges.integer("neighbourhood", "px", "Side n of the n x n neighbourhood of eq. 2.2; odd.",
                           "thesis eq. 2.2", {3, 101}, &ObservedEdgesConfig::neighbourhood);
    observed_edges.number("threshold", "", "A pixel whose c(u, v) is above it is an observed edge.", "thesis eq. 2.2",
                          not_negative, &ObservedEdgesConfig::threshold);
}

void add_samples_keys(Keys& keys) {
    auto samples = key_section(keys, "workload.samples", &FasterConfig::workload, &WorkloadConfig::samples);
    samples.integer("count", "samples", "Pose samples of one iteration.", "thesis 4.2.1", {0, 1'000'000},
                    &SamplesConfig::count);
    samples.number("translation_sigma_m", "m",
                   "Standard deviation of the samples around the true translation, per axis.", "this project",
                   not_negative, &SamplesConfig::translation_sigma_m);
    samples.number("rotation_sigma_deg", "degrees",
                   "Standard deviation of the samples' rotation angle about a random axis.", "this project",
                   not_negative, &SamplesConfig::rotation_sigma_deg);
    samples.integer("seed", "", "Seed of the pose samples.", "this project", any_seed, &SamplesConfig::seed);
    samples.of_kind(
        "poses", "",
        "Table of poses (CSV: R, t_m or t) that replaces the other keys of workload.samples; empty to draw them.",
        "this project", KeyKind::path, &SamplesConfig::poses);
}

}  // namespace

Keys workload_keys() {
    Keys keys;
    add_target_keys(keys);
    add_mesh_file_keys(keys);
    add_camera_keys(keys);
    add_depth_image_keys(keys);
    add_rendered_scene_keys(keys);
    add_noise_keys(keys);
    add_observed_edges_keys(keys);
    add_samples_keys(keys);
    return keys;
}

}  // namespace faster
