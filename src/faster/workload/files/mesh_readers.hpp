#pragma once
#include <filesystem>
#include <string_view>

#include "faster/workload/files/mesh_builder.hpp"

namespace faster::files {

// Readers of mesh files: `file` is the whole content of `path`, which is for messages only; no other file is opened.
// They take what has a place in the format and is not the surface as it comes (materials, groups, textures, normals,
// colours, comments, elements of no faces), and throw InputError at everything else: "path:line: what, expected". Time
// and memory are bounded by the length of the file, whatever it announces.

/// Wavefront OBJ: polygons (f), in the order of the file. Points and lines have no surface. Free-form surfaces and
/// files that include others are refused.
void read_obj(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh);

/// PLY, as text and in both byte orders: `face` and `tristrips`. Other elements with lists of vertices are refused.
void read_ply(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh);

/// STL, as text (any number of solids) and binary.
void read_stl(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh);

/// OFF as text, with normals, colours and textures (NOFF, COFF, STOFF).
void read_off(std::filesystem::path const& path, std::string_view file, MeshBuilder& mesh);

}  // namespace faster::files
