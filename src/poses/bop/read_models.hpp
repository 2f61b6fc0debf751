#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "poses/bop/dataset.hpp"

namespace faster::bop {

/// The objects of a folder, by obj_id. It holds
///   obj_NNNNNN.ply in millimetres, and models_info.json: the format of BOP; or
///   mesh files in metres, named after their classes: objects are numbered from 1 in the order of their names, and a
///   models_info.json is read if there is one;
/// `unit_m`, if given, is the length of a mesh's unit instead. In the format of BOP, `other_infos` is read in place of
/// a models_info.json that is not there. Throws InputError for a folder without meshes, and if both files are missing.
std::map<int, ObjectModel> read_models_folder(std::filesystem::path const& folder, std::optional<double> unit_m,
                                              std::vector<std::string>& warnings,
                                              std::filesystem::path const& other_infos = {});

}  // namespace faster::bop
