#pragma once
#include <cstdint>
#include <string>

#include "faster/config/workload_config.hpp"
#include "faster/data/mesh.hpp"

namespace faster::workload {

/// The longest side of the box around a mesh [m].
double longest_side_m(Mesh const& mesh);

/// What is wrong with the size of the object of a mesh file, for people; empty if nothing is. A camera of 3 m range
/// sees objects that are hand-sized: one of 10 m is one of 1 cm at least whose file is in millimetres, one of 3 m is
/// one of 3 cm in centimetres, and one of less than 5 mm is too small to be seen.
std::string length_warning(Mesh const& mesh, std::string const& file);

/// With the key that reads another unit.
std::string size_warning(Mesh const& mesh, std::string const& file);

/// What was left out of a mesh on simplifying it, for people; empty if nothing was.
std::string duplicates_warning(Mesh const& mesh, std::string const& file);

/// The mesh of an object: a mesh file if `name` has a '/' or the extension of a mesh format, else a built-in class.
/// Throws InputError; for an unknown class it names `key`, the configuration key the name comes from. `files`: what
/// reading a mesh file may take, and its unit.
Mesh object_mesh(std::string const& name, std::string const& key, MeshFilesConfig const& files = {});

/// What is expected instead of an object's name, for messages; empty if it is a mesh file's or a built-in class's.
std::string object_fault(std::string const& name);

/// Whether an object is a mesh file, not a built-in class.
bool is_mesh_file(std::string const& name);

/// The mesh with fewer triangles of the same shape and orientation; as it is if it has at most `max_triangles`, or if
/// that is 0. The limit is a goal: surfaces that cannot be collapsed further without breaking apart keep up to a tenth
/// more; beyond that vertices are merged on a grid, whatever becomes of holes and thin parts. Triangles that are there
/// several times are first left out but for one.
Mesh simplified(Mesh const& mesh, std::uint64_t max_triangles);

}  // namespace faster::workload
