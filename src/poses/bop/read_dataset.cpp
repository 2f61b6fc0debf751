#include "poses/bop/read_dataset.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <map>
#include <set>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/files/json_node.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/files/pose_numbers.hpp"
#include "faster/workload/files/tiff_image.hpp"
#include "poses/bop/mended_rotations.hpp"
#include "poses/bop/odd_lengths.hpp"
#include "poses/bop/read_models.hpp"
#include "poses/bop/scene_folder.hpp"

namespace faster::bop {

namespace {

namespace fs = std::filesystem;

/// However the folder was given: relative, or with a slash at its end.
fs::path plain(fs::path const& folder) {
    fs::path const normal = fs::absolute(folder).lexically_normal();
    return normal.has_filename() ? normal : normal.parent_path();
}
fs::path parent_of(fs::path const& folder) { return plain(folder).parent_path(); }
std::string name_of(fs::path const& folder) { return plain(folder).filename().string(); }

/// The dataset that a split belongs to: of a link to a split, where that is, unless the models lie beside the link.
fs::path folder_of_split(fs::path const& split) {
    fs::path const beside = parent_of(split);
    return fs::exists(beside / "models") ? beside : fs::canonical(split).parent_path();
}

std::set<fs::path> folders_in(fs::path const& folder) {
    std::set<fs::path> folders;
    for (auto const& entry : fs::directory_iterator(folder)) {
        if (entry.is_directory())
            folders.insert(entry.path());
    }
    return folders;
}

/// Those of a split that are scenes: folders NNNNNN with a camera file.
std::vector<fs::path> scene_folders_in(fs::path const& split) {
    std::vector<fs::path> scenes;
    for (fs::path const& folder : folders_in(split)) {
        std::string const name = folder.filename().string();
        bool const is_number = name.find_first_not_of("0123456789") == std::string::npos && name.size() <= 9;
        if (is_number && fs::exists(folder / "scene_camera.json"))
            scenes.push_back(folder);
    }
    return scenes;
}

std::map<int, fs::path> scenes_in(fs::path const& split) {
    std::map<int, fs::path> scenes;
    for (fs::path const& folder : scene_folders_in(split)) {
        int const id = std::stoi(folder.filename().string());
        auto const [found, is_new] = scenes.emplace(id, folder);
        if (!is_new)
            io::fail(folder, fmt::format("is scene {}, as {} is, expected one folder of a scene", id,
                                         found->second.filename().string()));
    }
    return scenes;
}

std::vector<std::string> splits_in(fs::path const& folder) {
    std::vector<std::string> splits;
    for (fs::path const& candidate : folders_in(folder)) {
        if (!scene_folders_in(candidate).empty())
            splits.push_back(candidate.filename().string());
    }
    return splits;
}

/// The folder of the scenes: the one asked for, the dataset itself if it is a split, `test`, or the only one.
fs::path split_of(fs::path const& folder, std::string const& wanted) {
    if (wanted.empty() && !scene_folders_in(folder).empty())
        return folder;
    std::vector<std::string> const splits = splits_in(folder);
    if (splits.empty())
        io::fail(
            folder,
            "holds no scenes, expected a dataset of BOP (SPLIT/NNNNNN/scene_camera.json), or frames.json in it or in "
            "folders of it");
    std::string const name = wanted.empty() && splits.size() == 1 ? splits.front() : wanted.empty() ? "test" : wanted;
    if (std::find(splits.begin(), splits.end(), name) == splits.end())
        io::fail(folder, fmt::format("has no split {}, expected {} {}", name,
                                     wanted.empty() ? "a split's folder instead, one of" : "--split with one of",
                                     fmt::join(splits, ", ")));
    return folder / name;
}

/// What camera.json says of the size of images, if it says it. It is meant for training images that are yet to be
/// rendered; the images at hand may have another size.
Camera common_size(fs::path const& root) {
    Camera size{0, 0, 1, 1, 0, 0};
    fs::path const file = root / "camera.json";
    if (!fs::exists(file))
        return size;
    Json const json = io::read_json_file(file, "camera.json as BOP has it");
    io::JsonNode const node(file, json);
    auto const width = node.find("width"), height = node.find("height");
    if (width && height) {
        size.width = width->integer(1);
        size.height = height->integer(1);
    }
    return size;
}

/// Objects of the folders asked for, then of the dataset's own; the first folder that has an object wins. What one of
/// the former does not say of its meshes, the dataset's own models_info.json does.
std::map<int, ObjectModel> models_of(DatasetOptions const& options, fs::path const& own,
                                     std::vector<std::string>& warnings) {
    std::map<int, ObjectModel> models;
    for (fs::path const& folder : options.models)
        models.merge(read_models_folder(folder, options.unit_m, warnings, own / "models_info.json"));
    if (options.models.empty() || fs::is_directory(own))
        models.merge(read_models_folder(own, options.unit_m, warnings));
    return models;
}

template <class Item> void append(std::vector<Item>& items, std::vector<Item> const& more) {
    items.insert(items.end(), more.begin(), more.end());
}

fs::path bop_models(fs::path const& root, bool to_judge) {
    return to_judge && fs::is_directory(root / "models_eval") ? root / "models_eval" : root / "models";
}

/// Everything that has been annotated in an image.
std::vector<Target> targets_in(DatasetImage const& image) {
    std::map<int, int> instances;
    for (GroundTruth const& object : image.objects)
        ++instances[object.obj_id];
    std::vector<Target> targets;
    targets.reserve(instances.size());
    for (auto const& [obj_id, count] : instances)
        targets.push_back({image.id, obj_id, count});
    return targets;
}

std::vector<Target> all_targets(std::vector<DatasetImage> const& images) {
    std::vector<Target> targets;
    for (DatasetImage const& image : images)
        append(targets, targets_in(image));
    return targets;
}

/// The targets of a row. One of test_targets_bop24.json has an image, in which everything is to be found; one of
/// test_targets_bop19.json an object, and how often it is there.
std::vector<Target> targets_of(io::JsonNode const& node, DatasetImage const& image) {
    auto const obj_id = node.find("obj_id"), count = node.find("inst_count");
    std::vector<Target> targets = targets_in(image);
    if (!obj_id)
        return targets;
    int const id = obj_id->integer(1);
    if (count)
        return {{image.id, id, count->integer(1)}};
    auto const found = std::find_if(targets.begin(), targets.end(), [id](Target const& t) { return t.obj_id == id; });
    return {found == targets.end() ? Target{image.id, id, 1} : *found};
}

/// By image and object; of rows that name the same, the last one counts.
void read_targets(fs::path const& file, Dataset& dataset) {
    Json const json = io::read_json_file(file, "targets as BOP has them");
    std::map<std::pair<ImageId, int>, Target> targets;
    std::size_t rows = 0, elsewhere = 0, repeated = 0;
    for (io::JsonNode const& node : io::JsonNode(file, json).items()) {
        ImageId const id{node.at("scene_id").integer(0), node.at("im_id").integer(0)};
        DatasetImage const* const image = dataset.find(id);
        ++rows;
        if (image == nullptr)
            ++elsewhere;
        else
            for (Target const& target : targets_of(node, *image))
                repeated += targets.insert_or_assign({id, target.obj_id}, target).second ? 0U : 1U;
    }
    for (auto const& [name, target] : targets)
        dataset.targets.push_back(target);
    if (elsewhere > 0)
        dataset.warnings_of_targets.push_back(
            fmt::format("{}: {} of {} targets are in images that are not at hand, and are left out", file.string(),
                        elsewhere, rows));
    if (repeated > 0)
        dataset.warnings_of_targets.push_back(
            fmt::format("{}: {} rows name a target that another row names, expected each once; "
                        "the last one counts",
                        file.string(), repeated));
}

/// The targets of a dataset; empty if it has none. Those of the challenge's first task come first.
fs::path targets_file(fs::path const& root) {
    for (char const* const name : {"test_targets_bop19.json", "test_targets_bop24.json"}) {
        if (fs::exists(root / name))
            return root / name;
    }
    return {};
}

Dataset read_bop(fs::path const& folder, DatasetOptions const& options) {
    fs::path const split = split_of(folder, options.split);
    fs::path const root = split == folder ? folder_of_split(folder) : folder;
    Dataset dataset;
    dataset.folder = folder;
    dataset.models = models_of(options, bop_models(root, options.to_judge), dataset.warnings);
    for (auto& [id, model] : dataset.models)
        if (fs::path const judged = root / "models_eval" / model.mesh.filename(); fs::exists(judged))
            model.judged_mesh = judged;
    Camera const size = common_size(root);
    MendedRotations mended;
    for (auto const& [scene_id, scene] : scenes_in(split))
        append(dataset.images, read_scene_folder(scene, scene_id, size, mended));
    std::string const poses = (split / "*" / "scene_gt.json").string();
    mended.tell(poses, dataset.warnings);
    tell_of_translations(dataset, poses + ": cam_t_m2c", files::m_per_mm);
    fs::path const targets = targets_file(root);
    if (!targets.empty() && name_of(split).rfind("test", 0) == 0) {
        dataset.targets_file = targets;
        read_targets(targets, dataset);
    } else
        dataset.targets = all_targets(dataset.images);
    return dataset;
}

/// `scenes` are folders with a frames.json.
Dataset read_frames(fs::path const& folder, std::vector<fs::path> const& scenes, fs::path const& meshes,
                    DatasetOptions const& options) {
    Dataset dataset;
    dataset.folder = folder;
    dataset.models = models_of(options, meshes, dataset.warnings);
    MendedRotations mended;
    for (std::size_t i = 0; i < scenes.size(); ++i)
        append(dataset.images, read_frames_folder(scenes[i], static_cast<int>(i) + 1, dataset.models, mended));
    fs::path const told = scenes.size() == 1 ? scenes.front() : parent_of(scenes.front()) / "*";
    std::string const poses = (told / "frames.json").string();
    mended.tell(poses, dataset.warnings);
    tell_of_translations(dataset, poses + ": t_scan", 1);
    dataset.targets = all_targets(dataset.images);
    return dataset;
}

std::vector<fs::path> frames_below(fs::path const& folder) {
    std::vector<fs::path> found;
    if (fs::is_directory(folder)) {
        for (fs::path const& candidate : folders_in(folder)) {
            if (fs::exists(candidate / "frames.json"))
                found.push_back(candidate);
        }
    }
    return found;
}

}  // namespace

DatasetImage const* Dataset::find(ImageId id) const {
    auto const found = std::lower_bound(images.begin(), images.end(), id,
                                        [](DatasetImage const& image, ImageId wanted) { return image.id < wanted; });
    return found != images.end() && found->id == id ? &*found : nullptr;
}

std::string Dataset::place_of_targets() const { return (targets_file.empty() ? folder : targets_file).string(); }

Dataset read_dataset(fs::path const& folder, DatasetOptions const& options) {
    if (!fs::is_directory(folder))
        io::fail(folder,
                 fs::exists(folder) ? "is no folder, expected one, a dataset" : "no such folder, expected a dataset");
    if (fs::exists(folder / "frames.json"))
        return read_frames(folder, {folder}, parent_of(parent_of(folder)) / "meshes", options);
    if (auto const scenes = frames_below(folder / "depth"); !scenes.empty())
        return read_frames(folder, scenes, folder / "meshes", options);
    if (auto const scenes = frames_below(folder); !scenes.empty())
        return read_frames(folder, scenes, parent_of(folder) / "meshes", options);
    return read_bop(folder, options);
}

Observation load_observation(DatasetImage const& image) {
    Image<std::uint16_t> const raw = files::read_depth_counts(sound(image).depth);
    Observation observation{image.camera, workload::DepthImage(raw.height(), raw.width())};
    if (image.has_size)
        files::require_size(image.depth, raw.width(), raw.height(), image.camera.width, image.camera.height,
                            "as frames.json says");
    observation.camera.width = raw.width();
    observation.camera.height = raw.height();
    std::transform(raw.pixels().begin(), raw.pixels().end(), observation.depth.pixels().begin(),
                   [&](std::uint16_t counts) { return image.depth_unit_m * counts; });
    return observation;
}

void tell_of_depths(Observation const& seen, DatasetImage const& image, std::vector<std::string>& warnings) {
    constexpr double far_m = 3, near_m = 0.1;
    auto const& depths = seen.depth.pixels();
    auto const count = [&](auto const& counts) { return std::count_if(depths.begin(), depths.end(), counts); };
    auto const readings = count([](double z) { return z > 0; });
    auto const near = count([](double z) { return z > 0 && z < near_m; });
    auto const far = count([](double z) { return z > far_m; });
    if (readings > 0 && (near == readings || far == readings))
        warnings.push_back(fmt::format(
            "{}: all of its {} readings are {} m, expected some between: {} = {:g} mm per count", image.depth.string(),
            readings, far == readings ? fmt::format("beyond {}", far_m) : fmt::format("below {}", near_m),
            image.has_size ? "depth_unit_m of frames.json" : "depth_scale of scene_camera.json",
            image.depth_unit_m / files::m_per_mm));
}

std::vector<Mesh> load_models(std::vector<ObjectModel const*> const& models, std::size_t jobs,
                              std::vector<std::string>& warnings) {
    std::vector<std::filesystem::path> files;
    files.reserve(models.size());
    for (ObjectModel const* const model : models)
        files.push_back(model->mesh);
    std::vector<Mesh> meshes = files::load_meshes(files, {}, jobs);
    for (std::size_t i = 0; i < meshes.size(); ++i)
        for (Eigen::Vector3d& vertex : meshes[i].vertices)
            vertex *= models[i]->unit_m;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        compare_with_info(meshes[i], *models[i], warnings);
        tell_of_length(meshes[i], *models[i], warnings);
    }
    return meshes;
}

Mesh load_model(ObjectModel const& model, std::vector<std::string>& warnings) {
    return std::move(load_models({&model}, 1, warnings).front());
}

Mesh load_judged_model(ObjectModel const& model, std::vector<std::string>& warnings) {
    ObjectModel judged = model;
    judged.mesh = model.judged_mesh.empty() ? model.mesh : model.judged_mesh;
    return load_model(judged, warnings);
}

namespace {

/// Where the mesh of an object would be, if meshes are called by number.
std::string missing_mesh(Dataset const& dataset, int obj_id) {
    if (dataset.models.empty() || dataset.models.begin()->second.name.rfind("obj_", 0) != 0)
        return "";
    fs::path const& mesh = dataset.models.begin()->second.mesh;
    return fmt::format(", of which there is no {}",
                       (mesh.parent_path() / fmt::format("obj_{:06}", obj_id)).string() + mesh.extension().string());
}

}  // namespace

ObjectModel const& model_of(Dataset const& dataset, int obj_id, std::string const& place) {
    auto const found = dataset.models.find(obj_id);
    if (found != dataset.models.end())
        return sound(found->second);
    std::vector<int> known;
    for (auto const& [id, model] : dataset.models)
        known.push_back(id);
    throw InputError(fmt::format("{}: obj_id = {}{}, expected one of the dataset's: {}", place, obj_id,
                                 missing_mesh(dataset, obj_id), fmt::join(known, ", ")));
}

ImageBox projected_box(Mesh const& mesh, Pose const& pose, Camera const& camera) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Eigen::Array2d low(infinite, infinite), high(-infinite, -infinite);
    for (Eigen::Vector3d const& vertex : mesh.vertices) {
        Eigen::Vector3d const p = pose.rotation * vertex + pose.translation;
        if (p.z() <= 0)
            continue;
        Eigen::Array2d const pixel(camera.fx * p.x() / p.z() + camera.cx, camera.fy * p.y() / p.z() + camera.cy);
        low = low.min(pixel);
        high = high.max(pixel);
    }
    return low.x() > high.x() ? ImageBox{} : ImageBox{low.x(), low.y(), high.x() - low.x(), high.y() - low.y()};
}

}  // namespace faster::bop
