#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "faster/workload/depth_image.hpp"
#include "poses/bop/dataset.hpp"

namespace faster::bop {

struct DatasetOptions {
    std::string split;                          ///< folder of the scenes; empty: `test`, or the only one with scenes
    std::vector<std::filesystem::path> models;  ///< folders looked through first for an object's mesh
    bool to_judge = false;                      ///< prefer models_eval/ to models/, as BOP's own evaluation does
    std::optional<double> unit_m = {};          ///< metres per unit of the meshes, if not as below
};

/// Reads all of a dataset but its images and meshes. `folder` is one of
///   a dataset in the format of BOP: SPLIT/NNNNNN/{scene_camera,scene_gt,scene_gt_info}.json and depth/, models/,
///   and test_targets_bop19.json or test_targets_bop24.json, and camera.json, if there are any;
///   one of its splits;
///   depth/NAME/frames.json with meshes/ beside depth/, that depth/, or one of these NAME: scenes are numbered from 1
///   by name, objects from 1 in the order of the meshes' names.
/// Lengths become metres. Targets in images that are not at hand are left out and counted. What is wrong with a single
/// image, object or model is kept as its problem, see sound(). Throws InputError: a missing file, JSON that is none.
Dataset read_dataset(std::filesystem::path const& folder, DatasetOptions const& options = {});

/// What a camera saw, and the camera, with the size of the image.
struct Observation {
    Camera camera;
    workload::DepthImage depth;
};
Observation load_observation(DatasetImage const& image);

/// A line in `warnings` if all readings are farther than 3 m or nearer than 0.1 m: of another unit than is told.
void tell_of_depths(Observation const& seen, DatasetImage const& image, std::vector<std::string>& warnings);

/// The meshes of objects in metres, in the frame that poses refer to, read by `jobs` processes at once. Throws
/// InputError for one that is not as large as models_info.json says; `warnings` tell of lesser differences.
std::vector<Mesh> load_models(std::vector<ObjectModel const*> const& models, std::size_t jobs,
                              std::vector<std::string>& warnings);

/// One mesh, in the same way.
Mesh load_model(ObjectModel const& model, std::vector<std::string>& warnings);

/// The mesh with which poses are judged.
Mesh load_judged_model(ObjectModel const& model, std::vector<std::string>& warnings);

/// The model of an object, which is sound(); throws the InputError "PLACE: obj_id = 7, expected one of the dataset's:
/// 1, 2, 5".
ObjectModel const& model_of(Dataset const& dataset, int obj_id, std::string const& place);

/// The box around an object's projected vertices, in front of the camera: as the `box` of an annotation.
ImageBox projected_box(Mesh const& mesh, Pose const& pose, Camera const& camera);

}  // namespace faster::bop
