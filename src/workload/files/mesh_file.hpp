#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "common/mesh.hpp"

namespace faster::io {

/// Extensions of the mesh formats load_mesh reads, lower case, with the dot.
std::vector<std::string> const& mesh_extensions();

/// True if the path ends in one of mesh_extensions(), in any case.
bool has_mesh_extension(std::filesystem::path const& path);

/// The triangles of a mesh file (obj, ply, stl, off) in file order: all its parts in one mesh, polygons cut into
/// triangles, points and lines left out, axes and units as they are (metres expected). Vertices of exactly equal
/// position are joined, vertices without a triangle dropped. Triangles without area and open or self-touching surfaces
/// are kept: they are the rasterizer's to cope with. Positions are read in single precision, as assimp does, which also
/// takes a vertex index beyond the end of an OFF file for the last vertex.
///
/// Throws InputError: missing file, unknown or unreadable format, no triangles, a coordinate that is not finite.
Mesh load_mesh(std::filesystem::path const& path);

}  // namespace faster::io
