#include "faster/workload/files/mesh_import.hpp"

#include <algorithm>
#include <array>
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fmt/format.h>
#include <new>
#include <optional>
#include <sstream>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "dataflow/base/files/file_error.hpp"
#include "dataflow/base/files/text_file.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/base/printable.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/ply_length.hpp"

namespace faster::files {

namespace {

/// Where a Wavefront OBJ file has a vertex with a coordinate that is not finite (in single precision). Only for error
/// messages: assimp forgets which vertex of the file a corner came from.
struct ObjVertexPlace {
    std::size_t index = 0;  ///< among the `v` lines, from 0
    std::size_t line = 0;   ///< in the file, from 1
};

/// stof throws for what does not fit; strtof says infinite, which is what we look for.
bool is_finite_number(std::string const& word) { return std::isfinite(std::strtof(word.c_str(), nullptr)); }

bool has_bad_coordinate(std::istringstream& words) {
    std::string word;
    for (int axis = 0; axis < 3 && words >> word; ++axis) {
        if (!is_finite_number(word)) {
            return true;
        }
    }
    return false;
}

std::optional<ObjVertexPlace> first_bad_obj_vertex(std::string_view file) {
    std::istringstream lines{std::string(file)};
    std::string line;
    ObjVertexPlace place;
    while (std::getline(lines, line)) {
        ++place.line;
        std::istringstream words(line);
        std::string keyword;
        words >> keyword;
        if (keyword != "v") {
            continue;
        }
        if (has_bad_coordinate(words)) {
            return place;
        }
        ++place.index;
    }
    return std::nullopt;
}

/// Gives equal points equal indices, in order of first appearance. Only exactly equal points are joined: any tolerance
/// would collapse meshes of small scale.
class VertexJoiner {
  public:
    /// Appends each new point to `vertices`, which must be empty and outlive the joiner.
    explicit VertexJoiner(std::vector<Eigen::Vector3d>& vertices) : vertices_(vertices) {}

    std::uint32_t index_of(Eigen::Vector3d const& point) {
        Eigen::Vector3d const key = point + Eigen::Vector3d::Zero();  // -0 becomes 0: equal, but of other bits
        auto const [entry, is_new] = indices_.try_emplace(key, static_cast<std::uint32_t>(vertices_.size()));
        if (is_new) {
            vertices_.push_back(point);
        }
        return entry->second;
    }

  private:
    struct Hash {
        std::size_t operator()(Eigen::Vector3d const& point) const {
            std::uint64_t hash = 0;
            for (double const coordinate : {point.x(), point.y(), point.z()}) {
                std::uint64_t bits = 0;
                std::memcpy(&bits, &coordinate, sizeof bits);
                hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
                hash ^= hash >> 32;
            }
            return static_cast<std::size_t>(hash);
        }
    };

    std::vector<Eigen::Vector3d>& vertices_;
    std::unordered_map<Eigen::Vector3d, std::uint32_t, Hash> indices_;
};

namespace fs = std::filesystem;

/// assimp's complaints may span lines and end in one; ours are one line.
std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char letter) { return std::iscntrl(letter) != 0; }, ' ');
    return shortened(text.substr(0, text.find_last_not_of(' ') + 1));
}

[[noreturn]] void fail_unreadable(fs::path const& path, std::string const& reason) {
    fail(path, fmt::format("cannot be read as a mesh ({}), expected a valid {} file", one_line(reason),
                           lower_case_extension(path).substr(1)));
}

/// Of a file that takes too much memory assimp says no more than of any other.
[[noreturn]] void fail_import(fs::path const& path, Assimp::Importer const& importer) {
    if (std::exception_ptr const& error = importer.GetException()) {
        try {
            std::rethrow_exception(error);
        } catch (std::bad_alloc const&) {
            throw;
        } catch (...) {  // has an error string as well
        }
    }
    fail_unreadable(path, importer.GetErrorString());
}

Eigen::Vector3d position(aiVector3D const& vertex) { return {vertex.x, vertex.y, vertex.z}; }

std::vector<aiMesh const*> parts_of(aiScene const& scene) { return {scene.mMeshes, scene.mMeshes + scene.mNumMeshes}; }

[[noreturn]] void fail_vertex(fs::path const& path, std::size_t index, Eigen::Vector3d const& vertex) {
    std::string place = path.string();
    if (lower_case_extension(path) == ".obj") {  // assimp numbers corners there, not the vertices of the file
        if (auto const found = first_bad_obj_vertex(read_file(path))) {
            index = found->index;
            place += fmt::format(":{}", found->line);
        }
    }
    throw InputError(fmt::format("{}: vertex {} (counted from 0) is ({}, {}, {}), expected finite coordinates", place,
                                 index, vertex.x(), vertex.y(), vertex.z()));
}

void check_vertices(fs::path const& path, aiScene const& scene) {
    std::size_t index = 0;
    for (aiMesh const* const part : parts_of(scene)) {
        for (unsigned vertex = 0; vertex < part->mNumVertices; ++vertex, ++index) {
            if (Eigen::Vector3d const point = position(part->mVertices[vertex]); !point.allFinite()) {
                fail_vertex(path, index, point);
            }
        }
    }
}

/// assimp hands out truncated and inconsistent face lists as they are; cutting polygons would then read out of bounds.
void check_faces(fs::path const& path, aiScene const& scene) {
    std::size_t index = 0;
    for (aiMesh const* const part : parts_of(scene)) {
        for (unsigned face = 0; face < part->mNumFaces; ++face, ++index) {
            aiFace const& corners = part->mFaces[face];
            bool const in_range = std::all_of(corners.mIndices, corners.mIndices + corners.mNumIndices,
                                              [&](unsigned vertex) { return vertex < part->mNumVertices; });
            if (corners.mNumIndices == 0 || !in_range) {
                fail_unreadable(path, fmt::format("face {} (counted from 0) {}", index,
                                                  in_range ? "is missing" : "names a vertex that does not exist"));
            }
        }
    }
}

/// The scene as it is in the file, checked, polygons cut into triangles.
aiScene const* import_scene(fs::path const& path, Assimp::Importer& importer) {
    if (lower_case_extension(path) == ".ply" && is_truncated_ply(read_file(path))) {
        fail_unreadable(path, "it ends early");
    }
    aiScene const* scene = importer.ReadFile(path.string(), 0);
    if (scene == nullptr) {
        fail_import(path, importer);
    }
    check_vertices(path, *scene);
    check_faces(path, *scene);
    scene = importer.ApplyPostProcessing(aiProcess_Triangulate);
    if (scene == nullptr) {
        fail_import(path, importer);
    }
    return scene;
}

void append_triangles(aiMesh const& part, VertexJoiner& joiner, Mesh& mesh) {
    for (unsigned face = 0; face < part.mNumFaces; ++face) {
        aiFace const& corners = part.mFaces[face];
        if (corners.mNumIndices != 3) {
            continue;  // a point or a line
        }
        std::array<std::uint32_t, 3> joined{};
        for (unsigned corner = 0; corner < 3; ++corner) {
            joined[corner] = joiner.index_of(position(part.mVertices[corners.mIndices[corner]]));
        }
        mesh.faces.push_back(joined);
    }
}

Mesh merged(aiScene const& scene) {
    Mesh mesh;
    VertexJoiner joiner(mesh.vertices);
    for (aiMesh const* const part : parts_of(scene)) {
        append_triangles(*part, joiner, mesh);
    }
    return mesh;
}

}  // namespace

std::string lower_case_extension(fs::path const& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return extension;
}

Mesh import_mesh(fs::path const& path) {
    Mesh mesh;
    try {
        Assimp::Importer importer;
        mesh = merged(*import_scene(path, importer));
    } catch (InputError const&) {
        throw;
    } catch (std::bad_alloc const&) {
        throw;
    } catch (std::exception const& error) {
        fail_unreadable(path, error.what());
    }
    if (mesh.faces.empty()) {
        fail(path, "has no triangles, expected at least one");
    }
    return mesh;
}

}  // namespace faster::files
