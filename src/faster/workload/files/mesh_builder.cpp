#include "faster/workload/files/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <meshoptimizer.h>
#include <utility>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/polygon_cutter.hpp"

namespace faster::files {
namespace {

/// Rotates triangles of a polygon that begin where the one before begins. The two of a quadrilateral begin at one
/// corner.
void part_beginnings(std::vector<CornerTriple>& triples) {
    if (triples.size() == 2)
        return;
    for (std::size_t i = 1; i < triples.size(); ++i)
        if (triples[i][0] == triples[i - 1][0])
            std::rotate(triples[i].begin(), triples[i].begin() + 2, triples[i].end());
}

/// Joins vertices of equal position: the first stands for them. Only exactly equal ones are joined: any tolerance would
/// collapse meshes of small scale.
Mesh mesh_of(std::vector<std::uint32_t> const& corners, std::vector<Eigen::Vector3f> const& vertices) {
    Mesh mesh;
    if (corners.empty())
        return mesh;
    std::vector<Eigen::Vector3f> keys;
    keys.reserve(vertices.size());
    for (Eigen::Vector3f const& vertex : vertices)
        keys.emplace_back(vertex + Eigen::Vector3f::Zero());  // -0 becomes 0: equal, but of other bits
    std::vector<unsigned> numbers(keys.size());               // in order of first appearance
    meshopt_generateVertexRemap(numbers.data(), corners.data(), corners.size(), keys.data(), keys.size(),
                                sizeof(Eigen::Vector3f));
    mesh.faces.resize(corners.size() / 3);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        unsigned const number = numbers[corners[i]];
        if (number == mesh.vertices.size())
            mesh.vertices.emplace_back(vertices[corners[i]].cast<double>());
        mesh.faces[i / 3][i % 3] = number;
    }
    return mesh;
}

bool is_finite_float(double value) { return std::abs(value) <= double{std::numeric_limits<float>::max()}; }

}  // namespace

void MeshBuilder::add_vertex(Eigen::Vector3d const& vertex, SayWhere const& place) {
    if (!is_finite_float(vertex.x()) || !is_finite_float(vertex.y()) || !is_finite_float(vertex.z()))
        throw InputError(fmt::format("{}: vertex {} (counted from 0) is ({}, {}, {}), expected finite coordinates",
                                     place(), vertices_.size(), vertex.x(), vertex.y(), vertex.z()));
    if (vertices_.size() >= std::numeric_limits<std::uint32_t>::max())
        throw InputError(fmt::format("{}: another vertex, expected less than 2^32", place()));
    vertices_.emplace_back(vertex.cast<float>());
}

void MeshBuilder::add_polygon(std::vector<std::uint32_t> const& corners) {
    if (corners.size() >= 3)
        corners_.insert(corners_.end(), corners.begin(), corners.end());
    ends_.push_back(corners_.size());
}

Mesh MeshBuilder::mesh() const {
    std::vector<std::uint32_t> of_triangles;
    std::vector<Eigen::Vector3d> points;
    std::size_t begin = 0;
    for (std::size_t const end : ends_) {
        std::size_t const first = std::exchange(begin, end);
        if (end == first)
            continue;
        points.clear();
        for (std::size_t corner = first; corner < end; ++corner)
            points.emplace_back(vertices_.at(corners_[corner]).cast<double>());
        std::vector<CornerTriple> triples = cut_polygon(points);
        part_beginnings(triples);
        for (CornerTriple const& triple : triples)
            for (std::size_t const corner : triple)
                of_triangles.push_back(corners_[first + corner]);
    }
    return mesh_of(of_triangles, vertices_);
}

}  // namespace faster::files
