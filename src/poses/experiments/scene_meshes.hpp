#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::experiments {

/// What made scenes are made from, by obj_id: the built-in meshes, or those of a folder whose files are called like the
/// classes, NAME.obj or 002_NAME.ply. They are moved so that their boxes have the origin in the middle.
/// Files are read `jobs` at once. `warnings` tell of meshes that look as if they were in another unit than metres.
/// Errors: InputError for a folder that has none, or two of a class, and as load_meshes().
std::map<int, Mesh> scene_meshes(std::filesystem::path const& folder, std::size_t jobs,
                                 std::vector<std::string>& warnings);

}  // namespace faster::experiments
