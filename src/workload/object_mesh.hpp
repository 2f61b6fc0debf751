#pragma once
#include <cstdint>
#include <string>

#include "common/mesh.hpp"
#include "faster/workload_config.hpp"

namespace faster::workload {

/// The mesh of an object: a mesh file if `name` has a '/' or the extension of a mesh format, else a built-in class.
/// Throws InputError; for an unknown class it names `key`, the configuration key the name comes from. `files`: what
/// reading a mesh file may take, and its unit.
Mesh object_mesh(std::string const& name, std::string const& key, MeshFilesConfig const& files = {});

/// Whether an object is a mesh file, not a built-in class.
bool is_mesh_file(std::string const& name);

/// The mesh with fewer triangles of the same shape and orientation; as it is if it has at most `max_triangles`, or if
/// that is 0. The limit is a goal: surfaces that cannot be collapsed further without breaking apart keep up to a tenth
/// more; beyond that vertices are merged on a grid, whatever becomes of holes and thin parts.
Mesh simplified(Mesh const& mesh, std::uint64_t max_triangles);

}  // namespace faster::workload
