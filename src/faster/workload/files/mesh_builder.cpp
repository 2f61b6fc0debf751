#include "faster/workload/files/mesh_builder.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <limits>
#include <unordered_map>
#include <utility>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/polygon_cutter.hpp"

namespace faster::files {
namespace {

/// Gives equal points equal indices, in order of first appearance. Only exactly equal points are joined: any tolerance
/// would collapse meshes of small scale.
class VertexJoiner {
  public:
    /// Appends each new point to `vertices`, which must be empty and outlive the joiner.
    explicit VertexJoiner(std::vector<Eigen::Vector3d>& vertices) : vertices_(vertices) {}

    std::uint32_t index_of(Eigen::Vector3d const& point) {
        Eigen::Vector3d const key = point + Eigen::Vector3d::Zero();  // -0 becomes 0: equal, but of other bits
        auto const [entry, is_new] = indices_.try_emplace(key, static_cast<std::uint32_t>(vertices_.size()));
        if (is_new)
            vertices_.push_back(point);
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

/// Rotates triangles of a polygon that begin where the one before begins. The two of a quadrilateral begin at one
/// corner.
void part_beginnings(std::vector<CornerTriple>& triples) {
    if (triples.size() == 2)
        return;
    for (std::size_t i = 1; i < triples.size(); ++i)
        if (triples[i][0] == triples[i - 1][0])
            std::rotate(triples[i].begin(), triples[i].begin() + 2, triples[i].end());
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
    Mesh mesh;
    VertexJoiner joiner(mesh.vertices);
    std::vector<Eigen::Vector3d> points;
    std::size_t begin = 0;
    for (std::size_t const end : ends_) {
        std::size_t const first = std::exchange(begin, end);
        if (end == first)
            continue;
        points.clear();
        for (std::size_t corner = first; corner < end; ++corner)
            points.push_back(position(corner));
        std::vector<CornerTriple> triples = cut_polygon(points);
        part_beginnings(triples);
        for (CornerTriple& triple : triples)
            for (std::size_t& corner : triple)
                corner += first;
        for (CornerTriple const& triple : triples)
            mesh.faces.push_back({joiner.index_of(position(triple[0])), joiner.index_of(position(triple[1])),
                                  joiner.index_of(position(triple[2]))});
    }
    return mesh;
}

Eigen::Vector3d MeshBuilder::position(std::size_t corner) const {
    return vertices_.at(corners_[corner]).cast<double>();
}

}  // namespace faster::files
