#include "faster/workload/models/primitives/box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

namespace faster::models {
namespace {

using GridPoint = Eigen::Array3i;

/// Grid points on the surface of the box; the faces share those on edges and corners.
class BoxGrid {
  public:
    BoxGrid(Eigen::Vector3d const& size, double edge_length) : size_(size) {
        for (int axis = 0; axis < 3; ++axis) {
            cells_(axis) = std::max(1, static_cast<int>(std::lround(size(axis) / edge_length)));
        }
    }

    /// The two faces across `axis`.
    void add_faces(int axis) {
        int const a = (axis + 1) % 3;
        int const b = (axis + 2) % 3;
        for (int i = 0; i < cells_(a); ++i) {
            for (int j = 0; j < cells_(b); ++j) {
                add_square(axis, 0, {i + 1, j}, {i, j + 1});
                add_square(axis, cells_(axis), {i, j}, {i + 1, j + 1});
            }
        }
    }

    Mesh take() { return std::move(mesh_); }

  private:
    /// The square between two opposite corners (i, j), (k, l) in plane `level`; counter-clockwise seen from +axis if
    /// both i < k and j < l, from -axis if only one is.
    void add_square(int axis, int level, std::array<int, 2> p, std::array<int, 2> q) {
        std::uint32_t const v0 = vertex(axis, level, p[0], p[1]);
        std::uint32_t const v1 = vertex(axis, level, q[0], p[1]);
        std::uint32_t const v2 = vertex(axis, level, q[0], q[1]);
        std::uint32_t const v3 = vertex(axis, level, p[0], q[1]);
        if ((std::min(p[0], q[0]) + std::min(p[1], q[1])) % 2 == 0) {  // alternating diagonals
            add_pair(v0, v1, v2, v3);
        } else {
            add_pair(v1, v2, v3, v0);
        }
    }

    void add_pair(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        mesh_.faces.push_back({a, b, c});
        mesh_.faces.push_back({a, c, d});
    }

    std::uint32_t vertex(int axis, int level, int i, int j) {
        GridPoint point;
        point(axis) = level;
        point((axis + 1) % 3) = i;
        point((axis + 2) % 3) = j;
        auto const [found, is_new] = known_.emplace(std::array<int, 3>{point.x(), point.y(), point.z()},
                                                    static_cast<std::uint32_t>(mesh_.vertices.size()));
        if (is_new) {
            mesh_.vertices.push_back(position(point));
        }
        return found->second;
    }

    Eigen::Vector3d position(GridPoint const& point) const {
        Eigen::Vector3d result;
        for (int axis = 0; axis < 3; ++axis) {
            result(axis) = size_(axis) * (static_cast<double>(point(axis)) / cells_(axis) - 0.5);
        }
        return result;
    }

    Eigen::Vector3d size_;
    GridPoint cells_;
    std::map<std::array<int, 3>, std::uint32_t> known_;
    Mesh mesh_;
};

}  // namespace

Mesh box(Eigen::Vector3d const& size, double edge_length) {
    BoxGrid grid(size, edge_length);
    for (int axis = 0; axis < 3; ++axis) {
        grid.add_faces(axis);
    }
    return grid.take();
}

}  // namespace faster::models
