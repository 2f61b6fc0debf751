#include "faster/workload/input_warnings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>

#include "dataflow/base/middle_of.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/workload/object_mesh.hpp"
#include "faster/workload/object_pose.hpp"

namespace faster::workload {
namespace {

constexpr double nearest_m = 0.1;  // no sensor reads less
constexpr double sensor_range_m = 3;

/// Twice the sum of the faces' areas as vectors, of their areas, and six times the volume between them and the middle.
struct Facing {
    Eigen::Vector3d vectors = Eigen::Vector3d::Zero();
    double areas = 0;
    double volume = 0;
};

Facing facing_of(Mesh const& mesh, Eigen::Vector3d const& middle) {
    Facing facing;
    for (auto const& face : mesh.faces) {
        Eigen::Vector3d const a = mesh.vertices[face[0]] - middle, b = mesh.vertices[face[1]] - middle,
                              c = mesh.vertices[face[2]] - middle;
        Eigen::Vector3d const area = (b - a).cross(c - a);
        facing.vectors += area;
        facing.areas += area.norm();
        facing.volume += a.dot(b.cross(c));
    }
    return facing;
}

/// Of a closed mesh, by its volume: the areas of a closed surface add up to nothing.
std::string inside_out_warning(Mesh const& mesh, std::string const& file) {
    constexpr double nearly_closed = 0.02;  // of the area
    constexpr double some_volume = 0.01;    // of the box
    Eigen::AlignedBox3d const box = box_of(mesh);
    if (box.isEmpty())
        return {};
    Facing const facing = facing_of(mesh, box.center());
    double const volume = facing.volume / 6;
    bool const is_closed = facing.vectors.norm() <= nearly_closed * facing.areas;
    if (!is_closed || box.volume() == 0 || volume > -some_volume * box.volume())
        return {};
    return fmt::format(
        "{}: its faces are turned inwards (a volume of {:.3g} m^3), so that its far side is drawn; expected "
        "corners counter-clockwise seen from outside (turn the faces in the file: no key does it)",
        file, volume);
}

std::string focal_warning(char const* key, double focal_px, int side_px) {
    constexpr double narrowest_deg = 3, widest_deg = 150;
    double const angle_deg = 2 * std::atan(side_px / (2 * focal_px)) / radians_per_degree;
    if (angle_deg >= narrowest_deg && angle_deg <= widest_deg)
        return {};
    return fmt::format(
        "workload.camera.{} = {:.6g}: sees {:.3g} degrees of {} pixels; expected a focal length in pixels, "
        "which gives {} to {} degrees",
        key, focal_px, angle_deg, side_px, narrowest_deg, widest_deg);
}

std::string axis_warning(char const* key, double centre_px, char const* side, int side_px) {
    if (centre_px >= 0 && centre_px < side_px)
        return {};
    return fmt::format(
        "workload.camera.{} = {:.6g}: the optical axis is outside of the image; expected 0 to {} "
        "(workload.camera.{} = {})",
        key, centre_px, side_px - 1, side, side_px);
}

std::string far_poses_warning(WorkloadConfig const& config, std::vector<Pose> const& poses) {
    constexpr double furthest_m = 10;
    auto const is_far = [](Pose const& pose) { return pose.translation.norm() > furthest_m; };
    auto const first = std::find_if(poses.begin(), poses.end(), is_far);
    auto const count = std::count_if(poses.begin(), poses.end(), is_far);
    if (2 * static_cast<std::size_t>(count) <= poses.size())
        return {};
    bool const is_table = !config.samples.poses.empty();
    return fmt::format("{}: {} of {} poses are further than {} m away, the first {:.4g} m; expected {}",
                       is_table ? config.samples.poses : "workload.pose.translation_m", count, poses.size(), furthest_m,
                       first->translation.stableNorm(),
                       is_table ? "metres in t_m and millimetres in t (workload.samples.poses)" : "metres");
}

/// A triangle is dropped if the code of a vertex' z does not fit 16 bits (docs/function.md#vertex-transform).
std::string lost_triangles_warning(Mesh const& mesh, std::vector<Pose> const& poses, FractionBits const& fraction) {
    constexpr double furthest_m = 3.99;
    constexpr int enough_bits = 14;
    double const reach_m = std::ldexp(1.0, 16 - fraction.vertex_z);
    auto const loses = [&](Pose const& pose) {
        return std::any_of(mesh.vertices.begin(), mesh.vertices.end(), [&](Eigen::Vector3d const& vertex) {
            double const z = pose.rotation.row(2).dot(vertex) + pose.translation.z();
            return z >= reach_m && z <= furthest_m;
        });
    };
    auto const count = reach_m > furthest_m ? 0 : std::count_if(poses.begin(), poses.end(), loses);
    if (count == 0)
        return {};
    return fmt::format(
        "accelerator.fraction_bits.vertex_z = {}: triangles that reach beyond {} m are dropped, as of {} of {} poses; "
        "expected at most {}, with which none are",
        fraction.vertex_z, reach_m, count, poses.size(), enough_bits);
}

/// Readings where one pose puts the box of an object.
struct Sight {
    std::vector<double> readings_m;
    bool meets = false;  ///< one is at the object's distance
};

void look(DepthImage const& depth, Camera const& camera, Eigen::AlignedBox3d const& box, Pose const& pose,
          Sight& sight) {
    constexpr double more_m = 0.05;
    Eigen::AlignedBox2d pixels;
    Eigen::AlignedBox<double, 1> distance;
    for (int corner = 0; corner < 8; ++corner) {
        Eigen::Vector3d const point =
            pose.rotation * box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) + pose.translation;
        if (point.z() < nearest_m)
            return;
        pixels.extend(Eigen::Vector2d(camera.fx * point.x() / point.z() + camera.cx,
                                      camera.fy * point.y() / point.z() + camera.cy));
        distance.extend(Eigen::Matrix<double, 1, 1>(point.z()));
    }
    Eigen::AlignedBox2d const image(Eigen::Vector2d(0, 0), Eigen::Vector2d(depth.width() - 1, depth.height() - 1));
    if (!pixels.intersects(image))
        return;
    pixels = pixels.intersection(image);
    double const margin_m = more_m + box.diagonal().norm() / 2;
    for (int row = static_cast<int>(pixels.min().y()); row <= static_cast<int>(pixels.max().y()); ++row)
        for (int column = static_cast<int>(pixels.min().x()); column <= static_cast<int>(pixels.max().x()); ++column)
            if (double const reading_m = depth.at(row, column); reading_m > 0) {
                sight.readings_m.push_back(reading_m);
                sight.meets |= reading_m > distance.min()[0] - margin_m && reading_m < distance.max()[0] + margin_m;
            }
}

std::vector<std::string> without_empty(std::vector<std::string> texts) {
    texts.erase(std::remove(texts.begin(), texts.end(), std::string{}), texts.end());
    return texts;
}

std::vector<std::string> depth_warnings(SceneConfig const& scene, Camera const& camera, Mesh const& mesh,
                                        std::vector<Pose> const& poses) {
    if (scene.depth_image.empty() || !std::filesystem::is_regular_file(scene.depth_image))
        return {};
    std::string const key = fmt::format("workload.scene.depth_unit_m = {}", scene.depth_unit_m);
    DepthImage const depth = load_depth_image(scene.depth_image, scene.depth_unit_m, camera, scene.downscale);
    std::string warning = depth_range_warning(depth, scene.depth_image, key);
    if (warning.empty())
        warning = depth_pose_warning(depth, downscaled(camera, scene.downscale), mesh, poses, scene.depth_image, key);
    return {warning};
}

}  // namespace

std::vector<std::string> mesh_warnings(Mesh const& mesh, std::string const& file) {
    return without_empty({size_warning(mesh, file), inside_out_warning(mesh, file), duplicates_warning(mesh, file)});
}

std::vector<std::string> camera_warnings(Camera const& camera) {
    return without_empty({focal_warning("fx", camera.fx, camera.width), focal_warning("fy", camera.fy, camera.height),
                          axis_warning("cx", camera.cx, "width", camera.width),
                          axis_warning("cy", camera.cy, "height", camera.height)});
}

std::string depth_range_warning(DepthImage const& depth, std::string const& file, std::string const& unit_key) {
    constexpr double nearly_all = 0.98;
    std::vector<double> readings_m;
    std::copy_if(depth.pixels().begin(), depth.pixels().end(), std::back_inserter(readings_m),
                 [](double reading_m) { return reading_m > 0; });
    if (readings_m.empty())
        return fmt::format("{}: none of its {} pixels has a reading; expected a scene of {} to {} m", file,
                           depth.pixels().size(), nearest_m, sensor_range_m);
    auto const share_of = [&](auto const& is_out) {
        return static_cast<double>(std::count_if(readings_m.begin(), readings_m.end(), is_out)) /
               static_cast<double>(readings_m.size());
    };
    double const far = share_of([](double reading_m) { return reading_m > sensor_range_m; });
    double const near = share_of([](double reading_m) { return reading_m < nearest_m; });
    if (far < nearly_all && near < nearly_all)
        return {};
    return fmt::format(
        "{}: {:.4g} % of its {} readings are {} {} m, and their median is {:.4g} m; expected a scene of {} "
        "to {} m ({})",
        file, 100 * std::max(far, near), readings_m.size(), far > near ? "beyond" : "below",
        far > near ? sensor_range_m : nearest_m, middle_of(readings_m), nearest_m, sensor_range_m, unit_key);
}

std::string depth_pose_warning(DepthImage const& depth, Camera const& camera, Mesh const& mesh,
                               std::vector<Pose> const& poses, std::string const& file, std::string const& unit_key) {
    constexpr std::size_t enough = 16;
    if (poses.empty() || mesh.vertices.empty())
        return {};
    Eigen::AlignedBox3d const box = box_of(mesh);
    Sight sight;
    std::size_t const step = (poses.size() + enough - 1) / enough;
    for (std::size_t i = 0; i < poses.size() && !sight.meets; i += step)
        look(depth, camera, box, poses[i], sight);
    if (sight.meets || sight.readings_m.empty())
        return {};
    return fmt::format(
        "{}: where the poses put the object, none of the readings is near it: their median is {:.4g} m, "
        "the first pose's distance {:.4g} m; expected readings of the object ({}, or the poses)",
        file, middle_of(sight.readings_m), poses[0].translation.z(), unit_key);
}

std::vector<std::string> input_warnings(WorkloadConfig const& config, Mesh const& mesh, std::vector<Pose> const& poses,
                                        FractionBits const& fraction) {
    std::vector<std::string> warnings;
    auto const add = [&](std::vector<std::string> more) { warnings.insert(warnings.end(), more.begin(), more.end()); };
    if (is_mesh_file(config.target.object))
        add(mesh_warnings(mesh, config.target.object));
    add(camera_warnings(config.camera));
    add({far_poses_warning(config, poses), lost_triangles_warning(mesh, poses, fraction)});
    add(depth_warnings(config.scene, config.camera, mesh, poses));
    return without_empty(std::move(warnings));
}

}  // namespace faster::workload
