#pragma once
#include <filesystem>
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::bop {

/// The images of a scene of BOP: NNNNNN/ with scene_camera.json and, where it has been annotated, scene_gt.json and
/// scene_gt_info.json. Sizes of images are `size`'s. Throws InputError.
std::vector<DatasetImage> read_scene_folder(std::filesystem::path const& folder, int scene_id, Camera const& size);

/// The images of a folder with a frames.json: intrinsics, and poses of the scanned meshes [m] by class; the objects of
/// `models` are found by their names. Throws InputError.
std::vector<DatasetImage> read_frames_folder(std::filesystem::path const& folder, int scene_id,
                                             std::map<int, ObjectModel> const& models);

}  // namespace faster::bop
