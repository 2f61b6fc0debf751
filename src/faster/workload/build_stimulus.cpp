#include "faster/workload/build_stimulus.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <utility>

#include "dataflow/base/files/csv_cells.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/object_mesh.hpp"
#include "faster/workload/object_pose.hpp"
#include "faster/workload/observed_edges.hpp"
#include "faster/workload/pose_list.hpp"
#include "faster/workload/sample_poses.hpp"
#include "faster/workload/scene_renderer.hpp"
#include "faster/workload/sensor_noise.hpp"

namespace faster::workload {
namespace {

/// docs/function.md#samples-and-cores.
constexpr double nearest_origin_m = 0.1;

/// The table stands `table_height_m` below the camera's axis at the object's distance and slopes towards the camera.
Plane table_plane(SceneConfig const& scene, Pose const& target) {
    double const tilt = scene.table_tilt_deg * radians_per_degree;
    return {{0, scene.table_height_m, target.translation.z()}, {0, -std::cos(tilt), -std::sin(tilt)}};
}

DepthImage rendered_scene(WorkloadConfig const& config, Mesh const& target_mesh, Pose const& target,
                          Camera const& camera) {
    SceneConfig const& scene = config.scene;
    DepthImage depth(camera.height, camera.width);
    draw_mesh(target_mesh, target, camera, depth);
    for (std::size_t index = 0; index < scene.objects.size(); ++index) {
        SceneObjectConfig const& object = scene.objects[index];
        Mesh const mesh =
            object_mesh(object.object, fmt::format("workload.scene.objects[{}].object", index), config.mesh_files);
        draw_mesh(mesh, configured_pose(object), camera, depth);
    }
    if (scene.table) {
        draw_plane(table_plane(scene, target), camera, depth);
    }
    add_sensor_noise(depth, scene.noise, scene.seed);
    return depth;
}

DepthImage observed_scene(WorkloadConfig const& config, Mesh const& target_mesh, Pose const& target) {
    SceneConfig const& scene = config.scene;
    if (!scene.depth_image.empty()) {
        return load_depth_image(scene.depth_image, scene.depth_unit_m, config.camera, scene.downscale);
    }
    return rendered_scene(config, target_mesh, target, downscaled(config.camera, scene.downscale));
}

/// Pixel coordinate of a projection, as an integer; `place` says whose it is.
std::int32_t centre_pixel(double pixel, std::string const& place) {
    double const floored = std::floor(pixel);
    using Limits = std::numeric_limits<std::int32_t>;
    if (!(floored >= Limits::min() && floored <= Limits::max())) {
        throw InputError(fmt::format("{} has its origin at pixel {}, expected one that fits 32 bits", place, pixel));
    }
    return static_cast<std::int32_t>(floored);
}

void require_in_front(double origin_z_m, std::string const& place, std::string const& hint) {
    if (!(origin_z_m >= nearest_origin_m)) {
        throw InputError(fmt::format("{} has its origin at z = {} m, expected at least {} m{}", place, origin_z_m,
                                     nearest_origin_m, hint));
    }
}

/// Poses that were drawn, or those of a table.
struct PoseSource {
    std::string table;
    std::size_t first_line;  ///< of its rows

    std::string place(std::size_t index) const {
        return table.empty() ? fmt::format("workload.samples: sample {}", index)
                             : fmt::format("{}:{}: the pose", table, index + first_line);
    }
};

SampleInput sample_input(Pose const& pose, Camera const& camera, std::size_t index, std::size_t triangles,
                         PoseSource const& source) {
    std::string const place = source.place(index);
    Eigen::Vector3d const& origin = pose.translation;
    std::string const hint = source.table.empty() ? " (reduce workload.samples.translation_sigma_m)"
                             : origin.z() < 0     ? " (the camera looks along z)"
                                                  : " (t_m is in metres, t in millimetres)";
    require_in_front(origin.z(), place, hint);
    SampleInput sample;
    sample.centre_row = centre_pixel(camera.fy * origin.y() / origin.z() + camera.cy, place);
    sample.centre_col = centre_pixel(camera.fx * origin.x() / origin.z() + camera.cx, place);
    sample.triangle_count = static_cast<std::uint32_t>(triangles);
    return sample;
}

}  // namespace

Stimulus observed_stimulus(Mesh const& mesh, DepthImage const& depth, Camera const& camera,
                           WorkloadConfig const& config, int window, FractionBits const& fraction) {
    Stimulus stimulus;
    stimulus.posed.camera = camera;
    stimulus.posed.mesh = simplified(mesh, config.max_triangles);
    stimulus.width = camera.width;
    stimulus.height = camera.height;
    stimulus.window = window;
    stimulus.fraction = fraction;
    stimulus.observed_depth = depth_codes(depth, fraction.depth_buffer);
    stimulus.observed_edges = observed_edges(depth, camera, config.observed_edges);
    return stimulus;
}

Stimulus build_observation(WorkloadConfig const& config, int window, FractionBits const& fraction) {
    Pose const target = configured_pose(config.target);
    require_in_front(target.translation.z(), "workload.pose.translation_m: the object", "");
    Mesh const mesh = object_mesh(config.target.object, "workload.object", config.mesh_files);
    DepthImage const depth = observed_scene(config, mesh, target);
    return observed_stimulus(mesh, depth, downscaled(config.camera, config.scene.downscale), config, window, fraction);
}

void set_poses(std::vector<Pose> poses, Stimulus& stimulus, std::string const& table) {
    PoseSource const source{table, !table.empty() && io::is_row_first(table) ? 1U : 2U};
    stimulus.samples.clear();
    for (std::size_t index = 0; index < poses.size(); ++index) {
        stimulus.samples.push_back(
            sample_input(poses[index], stimulus.posed.camera, index, stimulus.posed.mesh.faces.size(), source));
    }
    stimulus.posed.poses = std::move(poses);
}

Stimulus build_stimulus(WorkloadConfig const& config, int window, FractionBits const& fraction) {
    Stimulus stimulus = build_observation(config, window, fraction);
    std::string const& table = config.samples.poses;
    set_poses(table.empty() ? sample_poses(configured_pose(config.target), config.samples) : read_pose_list(table),
              stimulus, table);
    return stimulus;
}

}  // namespace faster::workload
