#pragma once
#include <filesystem>
#include <vector>

#include "poses/bop/dataset.hpp"
#include "poses/bop/mended_rotations.hpp"

namespace faster::bop {

/// The images of a scene of BOP: NNNNNN/ with scene_camera.json and, where it has been annotated, scene_gt.json and
/// scene_gt_info.json. Sizes of images are `size`'s. Throws InputError.
/// An image of which one of the files lacks something keeps that as its problem, and so does an object.
std::vector<DatasetImage> read_scene_folder(std::filesystem::path const& folder, int scene_id, Camera const& size,
                                            MendedRotations& mended);

/// The images of a folder with a frames.json: intrinsics, and poses of the scanned meshes [m] by class; the objects of
/// `models` are found by their names. Throws InputError.
std::vector<DatasetImage> read_frames_folder(std::filesystem::path const& folder, int scene_id,
                                             std::map<int, ObjectModel> const& models, MendedRotations& mended);

}  // namespace faster::bop
