#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "faster/data/image.hpp"
#include "poses/bop/dataset.hpp"

namespace faster::bop {

// Files of a dataset in the format of BOP. Lengths in them are millimetres.

/// Counts of a pixel's distance in depth images: a tenth of a millimetre.
constexpr double written_depth_unit_m = 1e-4;

/// Of the images of one scene.
std::string scene_camera_json(std::vector<DatasetImage> const& images);
std::string scene_gt_json(std::vector<DatasetImage> const& images);
/// Every object must have its boxes and its visible share.
std::string scene_gt_info_json(std::vector<DatasetImage> const& images);
std::string targets_json(std::vector<Target> const& targets);

/// What models_info.json says of an object, from its mesh and its symmetries.
std::string models_info_json(std::map<int, ObjectModel> const& models, std::map<int, Mesh> const& meshes);

/// The mesh as text PLY, to a micrometre.
std::string ply_text(Mesh const& mesh);

/// Distances [m] as counts, the nearest; beyond 16 bits there is no reading.
Image<std::uint16_t> depth_counts(Image<double> const& depth);

}  // namespace faster::bop
