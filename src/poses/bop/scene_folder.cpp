#include "poses/bop/scene_folder.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/json_node.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "poses/bop/detections.hpp"

namespace faster::bop {
namespace {

namespace fs = std::filesystem;

using Images = std::map<int, DatasetImage>;  // by im_id

void read_camera(io::JsonNode const& node, DatasetImage& image) {
    std::vector<double> const k = node.at("cam_K").numbers(9);
    if (!(k[0] > 0 && k[4] > 0))
        node.at("cam_K").fail("focal lengths above 0");
    if (k[1] != 0 || k[3] != 0 || k[6] != 0 || k[7] != 0 || k[8] != 1)
        node.at("cam_K").fail("a camera without skew, row by row: fx, 0, cx, 0, fy, cy, 0, 0, 1");
    image.camera = {image.camera.width, image.camera.height, k[0], k[4], k[2], k[5]};
    auto const scale = node.find("depth_scale");
    image.depth_unit_m = files::m_per_mm * (scale ? scale->number_above_zero() : 1);
}

/// NNNNNN.png, or .tif as ITODD has it.
fs::path depth_file(fs::path const& folder, int im_id) {
    for (char const* const extension : {".png", ".tif", ".tiff"}) {
        fs::path file = folder / fmt::format("{:06}{}", im_id, extension);
        if (fs::exists(file))
            return file;
    }
    return folder / fmt::format("{:06}.png", im_id);
}

Images read_cameras(fs::path const& folder, int scene_id, Camera const& size) {
    fs::path const file = folder / "scene_camera.json";
    Json const json = io::read_json_file(file, "scene_camera.json as BOP has it");
    Images images;
    for (auto const& [im_id, node] : io::JsonNode(file, json).numbered()) {
        DatasetImage& image = images[im_id];
        image.id = {scene_id, im_id};
        image.camera = size;
        image.depth = depth_file(folder / "depth", im_id);
        read_into(image, [&, &node = node] { read_camera(node, image); });
    }
    return images;
}

/// `rotation`, `translation`: names of members; `metres`: of a unit of the translation.
Pose read_pose(io::JsonNode const& node, char const* rotation, char const* translation, double metres,
               MendedRotations& mended) {
    Pose pose;
    std::string problem;
    pose.rotation = mended.taken(files::matrix_of(node.at(rotation).numbers(9)), problem);
    if (!problem.empty())
        node.at(rotation).fail(problem);
    std::vector<double> const t = node.at(translation).numbers(3);
    pose.translation = metres * Eigen::Vector3d(t[0], t[1], t[2]);
    return pose;
}

GroundTruth read_object(io::JsonNode const& node, MendedRotations& mended) {
    GroundTruth object;
    object.obj_id = node.at("obj_id").integer(1);
    read_into(object, [&] { object.pose = read_pose(node, "cam_R_m2c", "cam_t_m2c", files::m_per_mm, mended); });
    return object;
}

void read_objects(fs::path const& file, int scene_id, Images& images, MendedRotations& mended) {
    Json const json = io::read_json_file(file, "scene_gt.json as BOP has it");
    for (auto const& [im_id, node] : io::JsonNode(file, json).numbered()) {
        auto const [image, is_new] = images.try_emplace(im_id);
        image->second.id = {scene_id, im_id};
        if (is_new)
            read_into(image->second, [&, &node = node] { node.fail("an image that scene_camera.json has, too"); });
        for (io::JsonNode const& object : node.items())
            image->second.objects.push_back(read_object(object, mended));
    }
}

/// Of what is not to be seen bop_toolkit writes boxes of four times -1; without a share they tell that it is hidden.
void read_object_info(io::JsonNode const& node, GroundTruth& object) {
    bool is_seen = true;
    if (auto const box = node.find("bbox_obj"))
        is_seen = (object.box = read_box(*box)).has_value();
    if (auto const box = node.find("bbox_visib"))
        is_seen = (object.visible_box = read_box(*box)).has_value();
    if (auto const share = node.find("visib_fract"))
        object.visible_share = std::max(0.0, share->number());
    else if (!is_seen)
        object.visible_share = 0;
    if (object.visible_share.value_or(0) > 1)
        node.at("visib_fract").fail("a share of the object, at most 1");
}

void read_image_infos(io::JsonNode const& node, DatasetImage& image) {
    std::vector<io::JsonNode> const infos = node.items();
    if (image.objects.size() != infos.size())
        node.fail("an object for each that scene_gt.json has in this image");
    for (std::size_t i = 0; i < infos.size(); ++i) {
        GroundTruth& object = image.objects[i];
        read_into(object, [&] { read_object_info(infos[i], object); });
    }
}

void read_object_infos(fs::path const& file, Images& images) {
    Json const json = io::read_json_file(file, "scene_gt_info.json as BOP has it");
    for (auto const& [im_id, node] : io::JsonNode(file, json).numbered()) {
        if (auto const image = images.find(im_id); image != images.end())
            read_into(image->second, [&, &node = node] { read_image_infos(node, image->second); });
    }
}

std::vector<DatasetImage> values_of(Images const& images) {
    std::vector<DatasetImage> values;
    for (auto const& [id, image] : images)
        values.push_back(image);
    return values;
}

/// The one of `models` that is called `name`.
int object_called(io::JsonNode const& name, std::map<int, ObjectModel> const& models) {
    std::string const wanted = name.text();
    for (auto const& [id, model] : models) {
        if (model.name == wanted)
            return id;
    }
    name.fail("the name of one of the meshes");
}

GroundTruth read_frame_object(io::JsonNode const& node, std::map<int, ObjectModel> const& models,
                              MendedRotations& mended) {
    GroundTruth object;
    object.obj_id = object_called(node.at("class"), models);
    object.pose = read_pose(node, "R", "t_scan", 1, mended);
    return object;
}

int number_of(io::JsonNode const& id) {
    std::string const text = id.text();
    if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
        id.fail("a number of up to nine digits, as text");
    return std::stoi(text);
}

DatasetImage read_frame(io::JsonNode const& node, fs::path const& folder, std::map<int, ObjectModel> const& models,
                        MendedRotations& mended) {
    DatasetImage image;
    image.id.im_id = number_of(node.at("id"));
    io::JsonNode const k = node.at("intrinsics");
    image.camera = {node.at("width").integer(1),    node.at("height").integer(1), k.at("fx").number_above_zero(),
                    k.at("fy").number_above_zero(), k.at("cx").number(),          k.at("cy").number()};
    image.has_size = true;
    image.depth_unit_m = node.at("depth_unit_m").number_above_zero();
    image.depth = folder / node.at("depth").text();
    if (auto const objects = node.find("objects"))
        for (io::JsonNode const& object : objects->items())
            image.objects.push_back(read_frame_object(object, models, mended));
    return image;
}

}  // namespace

std::vector<DatasetImage> read_scene_folder(fs::path const& folder, int scene_id, Camera const& size,
                                            MendedRotations& mended) {
    Images images = read_cameras(folder, scene_id, size);
    fs::path const objects = folder / "scene_gt.json", infos = folder / "scene_gt_info.json";
    if (fs::exists(objects))
        read_objects(objects, scene_id, images, mended);
    else if (fs::exists(infos))
        io::fail(objects, "no such file, expected it beside scene_gt_info.json");
    if (fs::exists(infos))
        read_object_infos(infos, images);
    return values_of(images);
}

std::vector<DatasetImage> read_frames_folder(fs::path const& folder, int scene_id,
                                             std::map<int, ObjectModel> const& models, MendedRotations& mended) {
    fs::path const file = folder / "frames.json";
    Json const json = io::read_json_file(file, "frames with intrinsics and poses");
    Images images;
    for (io::JsonNode const& node : io::JsonNode(file, json).at("frames").items()) {
        DatasetImage image = read_frame(node, folder, models, mended);
        image.id.scene_id = scene_id;
        if (!images.emplace(image.id.im_id, image).second)
            node.at("id").fail("each id once");
    }
    return values_of(images);
}

}  // namespace faster::bop
