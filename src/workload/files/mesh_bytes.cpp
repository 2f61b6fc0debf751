#include "workload/files/mesh_bytes.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <vector>

namespace faster::io {
namespace {

using Face = std::array<std::uint32_t, 3>;
constexpr std::size_t vertex_size = 3 * sizeof(double);

struct Counts {
    std::uint64_t vertices = 0;
    std::uint64_t faces = 0;
};

void put(void const* bytes, std::size_t count, std::string& text) {
    text.append(static_cast<char const*>(bytes), count);
}

}  // namespace

std::string mesh_bytes(Mesh const& mesh) {
    Counts const counts{mesh.vertices.size(), mesh.faces.size()};
    std::string text;
    text.reserve(sizeof counts + mesh.vertices.size() * vertex_size + mesh.faces.size() * sizeof(Face));
    put(&counts, sizeof counts, text);
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        put(vertex.data(), vertex_size, text);
    put(mesh.faces.data(), mesh.faces.size() * sizeof(Face), text);
    return text;
}

std::optional<Mesh> mesh_from_bytes(std::string_view bytes) {
    Counts counts;
    if (bytes.size() < sizeof counts)
        return std::nullopt;
    std::memcpy(&counts, bytes.data(), sizeof counts);
    bytes.remove_prefix(sizeof counts);
    if (counts.vertices > bytes.size() / vertex_size || counts.faces > bytes.size() / sizeof(Face) ||
        counts.vertices * vertex_size + counts.faces * sizeof(Face) != bytes.size())
        return std::nullopt;
    Mesh mesh;
    mesh.vertices.resize(counts.vertices);
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        std::memcpy(vertex.data(), bytes.data(), vertex_size);
        bytes.remove_prefix(vertex_size);
    }
    mesh.faces.resize(counts.faces);
    if (!bytes.empty())
        std::memcpy(mesh.faces.data(), bytes.data(), bytes.size());
    auto const is_there = [&](std::uint32_t vertex) { return vertex < counts.vertices; };
    auto const is_sound = [&](Face const& face) { return std::all_of(face.begin(), face.end(), is_there); };
    bool const is_finite = std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                                       [](Eigen::Vector3d const& vertex) { return vertex.allFinite(); });
    if (!is_finite || !std::all_of(mesh.faces.begin(), mesh.faces.end(), is_sound))
        return std::nullopt;
    return mesh;
}

}  // namespace faster::io
