#include "poses/bop/write_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "dataflow/base/json.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/pose_numbers.hpp"

namespace faster::bop {
namespace {

constexpr double mm_per_m = 1 / files::m_per_mm;

Json matrix_json(Eigen::Matrix3d const& m) {
    Json numbers = Json::array();
    for (Eigen::Index row = 0; row < 3; ++row)
        for (Eigen::Index column = 0; column < 3; ++column)
            numbers.push_back(m(row, column));
    return numbers;
}

Json vector_json(Eigen::Vector3d const& v) { return {v.x(), v.y(), v.z()}; }

Json box_json(ImageBox const& box) { return {box.left, box.top, box.width, box.height}; }

/// A row per image: their numbers are the keys.
template <class ValueOf> std::string per_image(std::vector<DatasetImage> const& images, ValueOf value_of) {
    Json file = Json::object();
    for (DatasetImage const& image : images)
        file[std::to_string(image.id.im_id)] = value_of(image);
    return file.dump(1) + "\n";
}

template <class ValueOf> std::string per_object(std::vector<DatasetImage> const& images, ValueOf value_of) {
    return per_image(images, [&](DatasetImage const& image) {
        Json list = Json::array();
        for (GroundTruth const& object : image.objects)
            list.push_back(value_of(object));
        return list;
    });
}

Json symmetry_json(Pose const& pose) {
    Json numbers = Json::array();
    for (Eigen::Index row = 0; row < 3; ++row) {
        for (Eigen::Index column = 0; column < 3; ++column)
            numbers.push_back(pose.rotation(row, column));
        numbers.push_back(mm_per_m * pose.translation(row));
    }
    for (int const last : {0, 0, 0, 1})
        numbers.push_back(last);
    return numbers;
}

Json info_json(ObjectModel const& model, Mesh const& mesh) {
    Eigen::AlignedBox3d const box = box_of(mesh);
    Json info{{"diameter", mm_per_m * diameter_of(mesh.vertices)}};
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
        std::string const name(1, "xyz"[axis]);
        info["min_" + name] = mm_per_m * box.min()(axis);
        info["size_" + name] = mm_per_m * box.sizes()(axis);
    }
    for (Pose const& symmetry : model.symmetries)
        info["symmetries_discrete"].push_back(symmetry_json(symmetry));
    for (ObjectModel::Axis const& axis : model.axes)
        info["symmetries_continuous"].push_back(
            {{"axis", vector_json(axis.direction)}, {"offset", vector_json(mm_per_m * axis.offset)}});
    return info;
}

}  // namespace

std::string scene_camera_json(std::vector<DatasetImage> const& images) {
    return per_image(images, [](DatasetImage const& image) -> Json {
        Camera const& c = image.camera;
        return {{"cam_K", {c.fx, 0.0, c.cx, 0.0, c.fy, c.cy, 0.0, 0.0, 1.0}},
                {"depth_scale", mm_per_m * image.depth_unit_m}};
    });
}

std::string scene_gt_json(std::vector<DatasetImage> const& images) {
    return per_object(images, [](GroundTruth const& object) -> Json {
        return {{"cam_R_m2c", matrix_json(object.pose.rotation)},
                {"cam_t_m2c", vector_json(mm_per_m * object.pose.translation)},
                {"obj_id", object.obj_id}};
    });
}

std::string scene_gt_info_json(std::vector<DatasetImage> const& images) {
    return per_object(images, [](GroundTruth const& object) -> Json {
        return {{"bbox_obj", box_json(object.box.value())},
                {"bbox_visib", box_json(object.visible_box.value())},
                {"visib_fract", object.visible_share.value()}};
    });
}

std::string targets_json(std::vector<Target> const& targets) {
    Json file = Json::array();
    for (Target const& target : targets)
        file.push_back({{"im_id", target.image.im_id},
                        {"inst_count", target.inst_count},
                        {"obj_id", target.obj_id},
                        {"scene_id", target.image.scene_id}});
    return file.dump(1) + "\n";
}

std::string models_info_json(std::map<int, ObjectModel> const& models, std::map<int, Mesh> const& meshes) {
    Json file = Json::object();
    for (auto const& [id, model] : models)
        file[std::to_string(id)] = info_json(model, meshes.at(id));
    return file.dump(1) + "\n";
}

std::string ply_text(Mesh const& mesh) {
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float z\n"
        "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
        mesh.vertices.size(), mesh.faces.size());
    for (Eigen::Vector3d const& v : mesh.vertices)
        fmt::format_to(std::back_inserter(text), "{:.3f} {:.3f} {:.3f}\n", mm_per_m * v.x(), mm_per_m * v.y(),
                       mm_per_m * v.z());
    for (auto const& face : mesh.faces)
        fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", face[0], face[1], face[2]);
    return text;
}

Image<std::uint16_t> depth_counts(Image<double> const& depth) {
    constexpr double most = 65535;
    Image<std::uint16_t> counts(depth.height(), depth.width());
    std::transform(depth.pixels().begin(), depth.pixels().end(), counts.pixels().begin(), [](double depth_m) {
        double const count = std::round(depth_m / written_depth_unit_m);
        return static_cast<std::uint16_t>(count > most ? 0 : count);
    });
    return counts;
}

}  // namespace faster::bop
