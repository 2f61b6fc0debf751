#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "faster/workload/depth_image.hpp"
#include "poses/bop/dataset.hpp"

namespace faster::bop {

struct DatasetOptions {
    std::string split;                          ///< folder of the scenes; empty: `test`, or the only one with scenes
    std::vector<std::filesystem::path> models;  ///< folders looked through first for an object's mesh
    bool to_judge = false;                      ///< prefer models_eval/ to models/, as BOP's own evaluation does
};

/// Reads all of a dataset but its images and meshes. `folder` is one of
///   a dataset in the format of BOP: SPLIT/NNNNNN/{scene_camera,scene_gt,scene_gt_info}.json and depth/, models/,
///   and test_targets_bop19.json and camera.json if there are any;
///   one of its splits;
///   depth/NAME/frames.json with meshes/ beside depth/, or one of these NAME: scenes are numbered from 1 by name,
///   objects from 1 in the order of the meshes' names.
/// Lengths become metres. Throws InputError: a missing file, a value that is none (JSON's path is named), a matrix that
/// is no rotation, a target that is not in any image.
Dataset read_dataset(std::filesystem::path const& folder, DatasetOptions const& options = {});

/// What a camera saw, and the camera, with the size of the image.
struct Observation {
    Camera camera;
    workload::DepthImage depth;
};
Observation load_observation(DatasetImage const& image);

/// The meshes of objects in metres, in the frame that poses refer to, read by `jobs` processes at once.
std::vector<Mesh> load_models(std::vector<ObjectModel const*> const& models, std::size_t jobs);

/// The mesh of one object in metres.
Mesh load_model(ObjectModel const& model);

/// The model of an object; throws the InputError "PLACE: obj_id = 7, expected one of the dataset's: 1, 2, 5".
ObjectModel const& model_of(Dataset const& dataset, int obj_id, std::string const& place);

/// The box around an object's projected vertices, in front of the camera: as the `box` of an annotation.
ImageBox projected_box(Mesh const& mesh, Pose const& pose, Camera const& camera);

}  // namespace faster::bop
