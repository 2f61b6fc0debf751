#include "support/bop_folder.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <stdexcept>
#include <vector>

#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/scene_renderer.hpp"

namespace faster::test {
namespace {

void add_quad(Mesh& mesh, std::array<std::uint32_t, 4> const& corners) {
    mesh.faces.push_back({corners[0], corners[1], corners[2]});
    mesh.faces.push_back({corners[0], corners[2], corners[3]});
}

/// 60 x 40 x 100 mm about the origin.
Mesh make_box() {
    Mesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.emplace_back((corner & 1) != 0 ? 0.03 : -0.03, (corner & 2) != 0 ? 0.02 : -0.02,
                                   (corner & 4) != 0 ? 0.05 : -0.05);
    for (auto const& side : std::vector<std::array<std::uint32_t, 4>>{
             {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        add_quad(mesh, side);
    return mesh;
}

/// 50 mm across and 80 mm long, about z; 63 corners, so that a fifth of the 315 turns of BOP maps it to itself.
Mesh make_cylinder() {
    constexpr std::uint32_t corners = 63;
    Mesh mesh;
    for (std::uint32_t i = 0; i < corners; ++i) {
        double const angle = 2 * portable::pi * i / corners;
        for (double const z : {-0.04, 0.04})
            mesh.vertices.emplace_back(0.025 * std::cos(angle), 0.025 * std::sin(angle), z);
    }
    mesh.vertices.emplace_back(0, 0, -0.04);
    mesh.vertices.emplace_back(0, 0, 0.04);
    for (std::uint32_t i = 0; i < corners; ++i) {
        std::uint32_t const here = 2 * i, next = 2 * ((i + 1) % corners);
        add_quad(mesh, {here, next, next + 1, here + 1});
        mesh.faces.push_back({2 * corners, next, here});
        mesh.faces.push_back({2 * corners + 1, here + 1, next + 1});
    }
    return mesh;
}

/// In millimetres.
std::string ply_of(Mesh const& mesh) {
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertices.size(), mesh.faces.size());
    for (auto const& v : mesh.vertices)
        text += fmt::format("{:.6f} {:.6f} {:.6f}\n", 1000 * v.x(), 1000 * v.y(), 1000 * v.z());
    for (auto const& face : mesh.faces)
        text += fmt::format("3 {} {} {}\n", face[0], face[1], face[2]);
    return text;
}

std::string const models_info = R"({
 "1": {"diameter": 123.288280, "min_x": -30, "min_y": -20, "min_z": -50, "size_x": 60, "size_y": 40, "size_z": 100,
       "symmetries_discrete": [[-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]]},
 "5": {"diameter": 94.339811, "min_x": -25, "min_y": -25, "min_z": -40, "size_x": 50, "size_y": 50, "size_z": 80,
       "symmetries_continuous": [{"axis": [0, 0, 2], "offset": [0, 0, 0]}]}
})";

std::string gt_of(int obj_id, Pose const& pose) {
    auto const& r = pose.rotation;
    Eigen::Vector3d const t = 1000 * pose.translation;
    return fmt::format(R"({{"cam_R_m2c": [{:.9f}, {:.9f}, {:.9f}, {:.9f}, {:.9f}, {:.9f}, {:.9f}, {:.9f}, {:.9f}],)"
                       R"( "cam_t_m2c": [{:.6f}, {:.6f}, {:.6f}], "obj_id": {}}})",
                       r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2), t.x(), t.y(),
                       t.z(), obj_id);
}

std::string gt_of(int obj_id, int im_id) { return gt_of(obj_id, BopFolder::pose_of(obj_id, im_id)); }

std::string gt_info_of(double visible) {
    return fmt::format(R"({{"bbox_obj": [10, 12, 20, 22], "bbox_visib": [11, 13, 9, 8], "px_count_all": 400,)"
                       R"( "px_count_valid": 390, "px_count_visib": 200, "visib_fract": {}}})",
                       visible);
}

std::string per_image(std::string const& of_0, std::string const& of_3) {
    return fmt::format("{{\n  \"0\": {},\n  \"3\": {}\n}}\n", of_0, of_3);
}

void write_depth(std::filesystem::path const& file, int im_id) {
    Camera const camera = BopFolder::camera();
    workload::DepthImage depth(camera.height, camera.width);
    for (int const obj_id : {BopFolder::box, BopFolder::cylinder})
        workload::draw_mesh(BopFolder::mesh_of(obj_id), BopFolder::pose_of(obj_id, im_id), camera, depth);
    Image<std::uint16_t> counts(camera.height, camera.width);
    for (int row = 0; row < camera.height; ++row) {
        for (int column = 0; column < camera.width; ++column)
            counts.at(row, column) =
                static_cast<std::uint16_t>(std::lround(depth.at(row, column) / BopFolder::depth_unit_m));
    }
    files::write_png(file, counts);
}

std::string targets() {
    std::string text;
    for (int const scene : {1, 2}) {
        for (int const image : {0, 3}) {
            for (int const object : {1, 5})
                text += fmt::format("{}{{\"im_id\": {}, \"inst_count\": 1, \"obj_id\": {}, \"scene_id\": {}}}",
                                    text.empty() ? "" : ",\n", image, object, scene);
        }
    }
    return "[" + text + "]\n";
}

}  // namespace

Mesh BopFolder::mesh_of(int obj_id) { return obj_id == box ? make_box() : make_cylinder(); }

Pose BopFolder::pose_of(int obj_id, int im_id) {
    Pose pose;
    Eigen::Vector3d const axis = obj_id == box ? Eigen::Vector3d(1, 0.2, 0) : Eigen::Vector3d(0.8, -0.3, 0.1);
    pose.rotation = Eigen::AngleAxisd(0.7 + 0.4 * im_id + obj_id, axis.normalized()).toRotationMatrix();
    pose.translation = {obj_id == box ? -0.06 : 0.07, 0.01 * im_id, 0.6};
    return pose;
}

BopFolder::BopFolder() {
    for (std::string const scene : {"000001", "000002"})
        std::filesystem::create_directories(path() / "test" / scene / "depth");
    std::filesystem::create_directories(path() / "models");
    write("models/obj_000001.ply", ply_of(make_box()));
    write("models/obj_000005.ply", ply_of(make_cylinder()));
    write("models/models_info.json", models_info);
    write("camera.json",
          R"({"cx": 31.5, "cy": 23.5, "depth_scale": 0.1, "fx": 60, "fy": 61, "height": 48, "width": 64})");
    write("test_targets_bop19.json", targets());
    std::string const camera = R"({"cam_K": [60.0, 0.0, 31.5, 0.0, 61.0, 23.5, 0.0, 0.0, 1.0], "depth_scale": 0.1})";
    for (std::string const scene : {"test/000001/", "test/000002/"}) {
        write(scene + "scene_camera.json", per_image(camera, camera));
        write(scene + "scene_gt.json",
              per_image("[" + gt_of(1, 0) + ", " + gt_of(5, 0) + "]", "[" + gt_of(1, 3) + ", " + gt_of(5, 3) + "]"));
        write(scene + "scene_gt_info.json", per_image("[" + gt_info_of(1) + ", " + gt_info_of(1) + "]",
                                                      "[" + gt_info_of(0.5) + ", " + gt_info_of(1) + "]"));
        for (int const im_id : {0, 3})
            write_depth(path() / scene / fmt::format("depth/{:06}.png", im_id), im_id);
    }
}

void BopFolder::write(std::string const& file, std::string const& content) const { folder_.write(file, content); }

void BopFolder::add_cylinder(double visible_share) const {
    Pose pose = pose_of(cylinder, 0);
    pose.translation.x() -= 0.3;
    replace("test/000001/scene_gt.json", R"("0": [)", R"("0": [)" + gt_of(cylinder, pose) + ", ");
    replace("test/000001/scene_gt_info.json", R"("0": [)", R"("0": [)" + gt_info_of(visible_share) + ", ");
}

void BopFolder::replace(std::string const& file, std::string const& from, std::string const& to) const {
    std::string content = content_of(path() / file);
    auto const place = content.find(from);
    if (place == std::string::npos)
        throw std::logic_error(file + " does not hold " + from);
    write(file, content.replace(place, from.size(), to));
}

}  // namespace faster::test
