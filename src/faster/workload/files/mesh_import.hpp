#pragma once
#include <filesystem>
#include <string>

#include "faster/data/mesh.hpp"

namespace faster::files {

/// The ending of a file's name with the dot, lower case.
std::string lower_case_extension(std::filesystem::path const& path);

/// What load_mesh() returns, read in this process. Throws InputError as load_mesh(), and std::bad_alloc.
Mesh import_mesh(std::filesystem::path const& path);

}  // namespace faster::files
