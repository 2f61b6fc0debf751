#pragma once
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster {

/// The smallest box with sides along the axes that holds all vertices [m]; empty without any.
inline Eigen::AlignedBox3d box_of(Mesh const& mesh) {
    Eigen::AlignedBox3d box;
    for (Eigen::Vector3d const& vertex : mesh.vertices)
        box.extend(vertex);
    return box;
}

/// The largest distance between two points.
inline double diameter_of(std::vector<Eigen::Vector3d> const& points) {
    double largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            largest = std::max(largest, (points[i] - points[j]).squaredNorm());
    }
    return std::sqrt(largest);
}

}  // namespace faster
