#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::files {

/// A mesh as bytes, from one process to another on the same host.
std::string mesh_bytes(Mesh const& mesh);

/// And back. Nothing if the lengths do not fit, or a face names a vertex that is not there: the bytes may come from a
/// process that has gone wrong.
std::optional<Mesh> mesh_from_bytes(std::string_view bytes);

/// Extensions of the mesh formats load_mesh reads, lower case, with the dot.
std::vector<std::string> const& mesh_extensions();

/// True if the path ends in one of mesh_extensions(), in any case.
bool has_mesh_extension(std::filesystem::path const& path);

/// The length of a mesh file [bytes]. Throws InputError for what load_mesh() would not open: no such file, a folder, a
/// pipe, another extension.
std::uint64_t require_mesh_file(std::filesystem::path const& path);

/// What reading a mesh file may take.
struct MeshLimits {
    double seconds = 10;
    std::uint64_t memory_mib = 1024;
    std::uint64_t file_mib = 256;
    std::string section;  ///< of the configuration, where these are keys; for messages

    std::uint64_t memory_bytes() const { return memory_mib << 20U; }
    std::uint64_t file_bytes() const { return file_mib << 20U; }
};

/// The triangles of a mesh file (obj, ply, stl, off) in file order: all its parts in one mesh, polygons and strips cut
/// into triangles, points and lines left out, axes and units as they are (metres expected). Vertices of exactly equal
/// position are joined, vertices without a triangle dropped. Triangles without area and open or self-touching surfaces
/// are kept: they are the rasterizer's to cope with. Positions are kept in single precision.
///
/// A process of its own reads it, which keeps to MeshLimits. Call it while the program has one thread only.
///
/// Throws InputError: missing file, unknown or unreadable format, a surface that is not read (free forms), no
/// triangles, a coordinate that is not finite, a limit exceeded.
Mesh load_mesh(std::filesystem::path const& path, MeshLimits const& limits = {});

/// Loads several files, `jobs` at once.
std::vector<Mesh> load_meshes(std::vector<std::filesystem::path> const& paths, MeshLimits const& limits,
                              std::size_t jobs);

}  // namespace faster::files
