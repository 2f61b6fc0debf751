#pragma once
#include <filesystem>
#include <map>

#include "workload/bop/dataset.hpp"

namespace faster::bop {

/// The objects of a folder, by obj_id. It holds
///   obj_NNNNNN.ply in millimetres and models_info.json: the format of BOP; or
///   mesh files in metres, named after their classes: objects are numbered from 1 in the order of their names, and a
///   models_info.json is read if there is one.
/// Throws InputError for a folder without meshes, a missing models_info.json, and what is wrong in it.
std::map<int, ObjectModel> read_models_folder(std::filesystem::path const& folder);

}  // namespace faster::bop
