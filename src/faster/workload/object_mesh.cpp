#include "faster/workload/object_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <meshoptimizer.h>
#include <numeric>
#include <utility>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "dataflow/base/nearest_name.hpp"
#include "faster/data/mesh_size.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/models/builtin_models.hpp"

namespace faster::workload {

namespace {

using Indices = std::vector<unsigned>;

/// Relative to the size of the mesh: the number of triangles decides, not the error.
constexpr float any_error = 1.0F;
/// Of triangles around a vertex, squared and summed, that edges are collapsed with in a second or two: meshoptimizer
/// looks at each of a vertex' triangles for each. A closed surface of a million vertices has 36 million.
constexpr std::uint64_t most_pairs_of_triangles = 1'000'000'000;

/// A mesh as meshoptimizer takes it.
struct FlatMesh {
    std::vector<float> positions;
    Indices indices;

    explicit FlatMesh(Mesh const& mesh) {
        for (auto const& vertex : mesh.vertices) {
            for (double const coordinate : {vertex.x(), vertex.y(), vertex.z()}) {
                positions.push_back(static_cast<float>(coordinate));
            }
        }
        for (auto const& face : mesh.faces) {
            indices.insert(indices.end(), face.begin(), face.end());
        }
    }
    std::size_t vertex_count() const { return positions.size() / 3; }
    static constexpr std::size_t stride = 3 * sizeof(float);
};

/// Each triangle once. Those that are there again, with the same front, change nothing that is seen, but meshoptimizer
/// takes their edges for places where surfaces meet, and what it makes of them is another shape.
Mesh without_duplicates(Mesh const& mesh) {
    using Face = std::array<std::uint32_t, 3>;
    std::vector<std::pair<Face, std::size_t>> numbered;  // from the least corner on
    numbered.reserve(mesh.faces.size());
    for (Face face : mesh.faces) {
        std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
        numbered.emplace_back(face, numbered.size());
    }
    std::sort(numbered.begin(), numbered.end());
    std::vector<bool> is_there_before(mesh.faces.size());
    for (std::size_t i = 1; i < numbered.size(); ++i)
        is_there_before[numbered[i].second] = numbered[i].first == numbered[i - 1].first;
    Mesh result{mesh.vertices, {}};
    for (std::size_t i = 0; i < mesh.faces.size(); ++i)
        if (!is_there_before[i])
            result.faces.push_back(mesh.faces[i]);
    result.duplicates = mesh.faces.size() - result.faces.size();
    return result;
}

bool can_be_collapsed(FlatMesh const& mesh) {
    std::vector<std::uint64_t> triangles(mesh.vertex_count());
    for (unsigned const vertex : mesh.indices)
        ++triangles[vertex];
    auto const pairs = [](std::uint64_t sum, std::uint64_t count) { return sum + count * count; };
    return std::accumulate(triangles.begin(), triangles.end(), std::uint64_t{0}, pairs) <= most_pairs_of_triangles;
}

Indices collapsed(FlatMesh const& mesh, std::size_t target_indices) {
    Indices result(mesh.indices.size());
    result.resize(meshopt_simplify(result.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.data(),
                                   mesh.vertex_count(), FlatMesh::stride, target_indices, any_error));
    return result;
}

Indices clustered(FlatMesh const& mesh, std::size_t target_indices) {
    Indices result(mesh.indices.size());
    result.resize(meshopt_simplifySloppy(result.data(), mesh.indices.data(), mesh.indices.size(), mesh.positions.data(),
                                         mesh.vertex_count(), FlatMesh::stride, target_indices, any_error));
    return result;
}

/// The triangles named by `indices`, with only the vertices they use, in order of first use.
Mesh compacted(Mesh const& mesh, Indices const& indices) {
    constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> new_index(mesh.vertices.size(), unused);
    Mesh result;
    result.duplicates = mesh.duplicates;
    result.faces.resize(indices.size() / 3);
    for (std::size_t position = 0; position < indices.size(); ++position) {
        std::uint32_t& index = new_index[indices[position]];
        if (index == unused) {
            index = static_cast<std::uint32_t>(result.vertices.size());
            result.vertices.push_back(mesh.vertices[indices[position]]);
        }
        result.faces[position / 3][position % 3] = index;
    }
    return result;
}

Mesh scaled(Mesh mesh, double scale) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= scale;
    return mesh;
}

constexpr double smallest_m = 0.005, largest_m = 3, too_large_for_centimetres_m = 10;

/// A unit that a file may have been written in, and the key's value that reads it.
struct LengthUnit {
    char const* name;
    char const* scale;
};
constexpr LengthUnit metres{"metres", "1"}, centimetres{"centimetres", "0.01"}, millimetres{"millimetres", "0.001"};

/// The unit that would make a mesh hand-sized; null if it is.
LengthUnit const* unit_of_length(double side_m) {
    constexpr double rounding = 1e-4;  // of positions in single precision, and of what is printed
    if (side_m < smallest_m * (1 - rounding))
        return &metres;
    if (side_m < largest_m)
        return nullptr;
    return side_m < too_large_for_centimetres_m ? &centimetres : &millimetres;
}

}  // namespace

double longest_side_m(Mesh const& mesh) {
    if (mesh.vertices.empty())
        return 0;
    return box_of(mesh).sizes().maxCoeff();
}

std::string length_warning(Mesh const& mesh, std::string const& file) {
    double const side_m = longest_side_m(mesh);
    LengthUnit const* const unit = unit_of_length(side_m);
    if (unit == nullptr)
        return {};
    if (unit == &metres)
        return fmt::format("{}: is {:.4g} m long; expected at least {} m", file, side_m, smallest_m);
    return fmt::format("{}: is {:.4g} m long, which looks like {}; expected less than {} m", file, side_m, unit->name,
                       largest_m);
}

std::string size_warning(Mesh const& mesh, std::string const& file) {
    std::string const text = length_warning(mesh, file);
    if (text.empty())
        return {};
    LengthUnit const& unit = *unit_of_length(longest_side_m(mesh));
    return fmt::format("{} (workload.mesh_files.scale: {} reads {})", text, unit.scale, unit.name);
}

std::string duplicates_warning(Mesh const& mesh, std::string const& file) {
    if (mesh.duplicates == 0)
        return {};
    return fmt::format(
        "{}: {} of its triangles have the corners of another, and were left out before it was simplified; "
        "expected each once",
        file, mesh.duplicates);
}

bool is_mesh_file(std::string const& name) {
    return name.find('/') != std::string::npos || files::has_mesh_extension(name);
}

std::string object_fault(std::string const& name) {
    if (is_mesh_file(name) || models::contains(name))
        return {};
    return fmt::format("a built-in class or a mesh file ({}){}", fmt::join(files::mesh_extensions(), ", "),
                       did_you_mean(name, models::names()));
}

Mesh object_mesh(std::string const& name, std::string const& key, MeshFilesConfig const& files) {
    if (is_mesh_file(name)) {
        return scaled(files::load_mesh(name, {files.time_limit_s, files.memory_limit_mib, files.file_limit_mib,
                                              "workload.mesh_files"}),
                      files.scale);
    }
    if (std::string const expected = object_fault(name); !expected.empty())
        throw InputError(fmt::format("{} = {}, expected {}", key, name, expected));
    return models::make(name);
}

Mesh simplified(Mesh const& mesh, std::uint64_t max_triangles) {
    if (max_triangles == 0 || mesh.faces.size() <= max_triangles) {
        return mesh;
    }
    Mesh once = without_duplicates(mesh);
    if (once.faces.size() <= max_triangles)
        return once;
    FlatMesh const flat(once);
    std::size_t const target_indices = 3 * static_cast<std::size_t>(max_triangles);
    Indices indices = can_be_collapsed(flat) ? collapsed(flat, target_indices) : flat.indices;
    if (indices.size() > target_indices + target_indices / 10) {
        Indices const coarser = clustered(flat, target_indices);
        if (!coarser.empty()) {
            indices = coarser;
        }
    }
    return compacted(once, indices);
}

}  // namespace faster::workload
