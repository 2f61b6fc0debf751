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
    keys.push_back(Make::make_key(
        {"workload.object", "",
         "The object whose pose is estimated: a built-in YCB class, or a mesh file (obj, ply, stl, "
         "off; has a / or . in its name).",
         "thesis 6"},
        KeyKind::object, [](auto& config) -> auto& { return config.workload.target.object; }));
    keys.back().words = class_or_mesh();
    keys.push_back(Make::integer_key(
        {"workload.max_triangles", "triangles",
         "The mesh is simplified to about this many triangles; 0 keeps it as it is.", "this project"},
        {0, 10'000'000}, [](auto& config) -> auto& { return config.workload.max_triangles; }));
    keys.push_back(Make::make_key(
        {"workload.trace", "", "Folder of a stimulus trace that replaces the rest of the workload; empty for none.",
         "docs/formats.md"},
        KeyKind::path, [](auto& config) -> auto& { return config.workload.trace; }));
    keys.push_back(Make::make_key(
        {"workload.pose.translation_m", "m", "Origin of the object in the camera frame.", "this project"},
        KeyKind::vector, [](auto& config) -> auto& { return config.workload.target.translation_m; }));
    keys.push_back(Make::make_key(
        {"workload.pose.rotation_deg", "degrees", "Rotation about the camera's x, then y, then z axis (R = Rz Ry Rx).",
         "this project"},
        KeyKind::vector, [](auto& config) -> auto& { return config.workload.target.rotation_deg; }));
}

void add_mesh_file_keys(Keys& keys) {
    keys.push_back(Make::number_key(
        {"workload.mesh_files.scale", "m",
         "Metres per unit of mesh files: 0.001 for millimetres. Built-in classes are in metres.", "this project"},
        positive, [](auto& config) -> auto& { return config.workload.mesh_files.scale; }));
    keys.push_back(of_no_figure(Make::number_key(
        {"workload.mesh_files.time_limit_s", "s", "How long reading a mesh file may take.", "this project"},
        {0, 86'400, true}, [](auto& config) -> auto& { return config.workload.mesh_files.time_limit_s; })));
    keys.push_back(of_no_figure(Make::integer_key(
        {"workload.mesh_files.memory_limit_mib", "MiB", "How much memory it may take.", "this project"}, {1, 1'048'576},
        [](auto& config) -> auto& { return config.workload.mesh_files.memory_limit_mib; })));
    keys.push_back(of_no_figure(Make::integer_key(
        {"workload.mesh_files.file_limit_mib", "MiB", "How long a mesh file may be.", "this project"}, {1, 1'048'576},
        [](auto& config) -> auto& { return config.workload.mesh_files.file_limit_mib; })));
}

void add_camera_keys(Keys& keys) {
    keys.push_back(Make::integer_key(
        {"workload.camera.width", "px", "Width of the image.", "this project"}, image_side,
        [](auto& config) -> auto& { return config.workload.camera.width; }));
    keys.push_back(Make::integer_key(
        {"workload.camera.height", "px", "Height of the image.", "this project"}, image_side,
        [](auto& config) -> auto& { return config.workload.camera.height; }));
    keys.push_back(Make::number_key(
        {"workload.camera.fx", "px", "Focal length along a row.", "this project"}, positive,
        [](auto& config) -> auto& { return config.workload.camera.fx; }));
    keys.push_back(Make::number_key(
        {"workload.camera.fy", "px", "Focal length along a column.", "this project"}, positive,
        [](auto& config) -> auto& { return config.workload.camera.fy; }));
    keys.push_back(Make::number_key(
        {"workload.camera.cx", "px", "Column of the optical axis.", "this project"}, {},
        [](auto& config) -> auto& { return config.workload.camera.cx; }));
    keys.push_back(Make::number_key(
        {"workload.camera.cy", "px", "Row of the optical axis.", "this project"}, {},
        [](auto& config) -> auto& { return config.workload.camera.cy; }));
}

void add_depth_image_keys(Keys& keys) {
    keys.push_back(Make::make_key(
        {"workload.scene.depth_image", "", "16-bit greyscale PNG or TIFF of the observed scene; empty to render one.",
         "this project"},
        KeyKind::path, [](auto& config) -> auto& { return config.workload.scene.depth_image; }));
    keys.push_back(Make::number_key(
        {"workload.scene.depth_unit_m", "m", "Metres per unit of the depth image.", "this project"}, positive,
        [](auto& config) -> auto& { return config.workload.scene.depth_unit_m; }));
    keys.push_back(Make::integer_key(
        {"workload.scene.downscale", "", "Every n-th pixel of the scene is kept, and the camera divided by n.",
         "this project"},
        {1, 64}, [](auto& config) -> auto& { return config.workload.scene.downscale; }));
}

void add_rendered_scene_keys(Keys& keys) {
    keys.push_back(Make::boolean_key(
        {"workload.scene.table", "", "Whether a rendered scene has a table.", "this project"},
        [](auto& config) -> auto& { return config.workload.scene.table; }));
    keys.push_back(Make::number_key(
        {"workload.scene.table_height_m", "m", "Camera y (down) of the table at x = 0 and the object's z.",
         "this project"},
        {}, [](auto& config) -> auto& { return config.workload.scene.table_height_m; }));
    keys.push_back(Make::number_key(
        {"workload.scene.table_tilt_deg", "degrees", "Angle by which the camera looks down on the table.",
         "this project"},
        {0, 90}, [](auto& config) -> auto& { return config.workload.scene.table_tilt_deg; }));
    keys.push_back(scene_objects_key());
    keys.push_back(Make::integer_key(
        {"workload.scene.seed", "", "Seed of the sensor noise.", "this project"}, any_seed,
        [](auto& config) -> auto& { return config.workload.scene.seed; }));
}

void add_noise_keys(Keys& keys) {
    keys.push_back(Make::boolean_key(
        {"workload.scene.noise.enabled", "", "Whether a rendered scene gets sensor noise.", noise_source},
        [](auto& config) -> auto& { return config.workload.scene.noise.enabled; }));
    keys.push_back(Make::number_key(
        {"workload.scene.noise.axial_base_m", "m", "Standard deviation of depth at axial_offset_m.", noise_source},
        not_negative, [](auto& config) -> auto& { return config.workload.scene.noise.axial_base_m; }));
    keys.push_back(Make::number_key(
        {"workload.scene.noise.axial_quadratic", "1/m",
         "Growth of the standard deviation with the square of z - axial_offset_m.", noise_source},
        not_negative, [](auto& config) -> auto& { return config.workload.scene.noise.axial_quadratic; }));
    keys.push_back(Make::number_key(
        {"workload.scene.noise.axial_offset_m", "m", "Depth of least noise.", noise_source}, not_negative,
        [](auto& config) -> auto& { return config.workload.scene.noise.axial_offset_m; }));
    keys.push_back(Make::number_key(
        {"workload.scene.noise.edge_dropout", "probability", "Chance of a missing reading at a depth edge.",
         "this project"},
        probability, [](auto& config) -> auto& { return config.workload.scene.noise.edge_dropout; }));
    keys.push_back(Make::number_key(
        {"workload.scene.noise.edge_step_m", "m", "Depth difference of neighbouring pixels that makes a depth edge.",
         "this project"},
        positive, [](auto& config) -> auto& { return config.workload.scene.noise.edge_step_m; }));
    keys.push_back(Make::number_key(
        {"workload.scene.noise.random_dropout", "probability", "Chance of a missing reading anywhere.", "this project"},
        probability, [](auto& config) -> auto& { return config.workload.scene.noise.random_dropout; }));
}

void add_observed_edges_keys(Keys& keys) {
    keys.push_back(Make::integer_key(
        {"workload.observed_edges.neighbourhood", "px", "Side n of the n x n neighbourhood of eq. 2.2; odd.",
         "thesis eq. 2.2"},
        {3, 101}, [](auto& config) -> auto& { return config.workload.observed_edges.neighbourhood; }));
    keys.push_back(Make::number_key(
        {"workload.observed_edges.threshold", "", "A pixel whose c(u, v) is above it is an observed edge.",
         "thesis eq. 2.2"},
        not_negative, [](auto& config) -> auto& { return config.workload.observed_edges.threshold; }));
}

void add_samples_keys(Keys& keys) {
    keys.push_back(Make::integer_key(
        {"workload.samples.count", "samples", "Pose samples of one iteration.", "thesis 4.2.1"}, {0, 1'000'000},
        [](auto& config) -> auto& { return config.workload.samples.count; }));
    keys.push_back(Make::number_key(
        {"workload.samples.translation_sigma_m", "m",
         "Standard deviation of the samples around the true translation, per axis.", "this project"},
        not_negative, [](auto& config) -> auto& { return config.workload.samples.translation_sigma_m; }));
    keys.push_back(Make::number_key(
        {"workload.samples.rotation_sigma_deg", "degrees",
         "Standard deviation of the samples' rotation angle about a random axis.", "this project"},
        not_negative, [](auto& config) -> auto& { return config.workload.samples.rotation_sigma_deg; }));
    keys.push_back(Make::integer_key(
        {"workload.samples.seed", "", "Seed of the pose samples.", "this project"}, any_seed,
        [](auto& config) -> auto& { return config.workload.samples.seed; }));
    keys.push_back(Make::make_key(
        {"workload.samples.poses", "",
         "Table of poses (CSV: R, t_m or t) that replaces the other keys of workload.samples; empty to draw them.",
         "this project"},
        KeyKind::path, [](auto& config) -> auto& { return config.workload.samples.poses; }));
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
