#pragma once
#include <Eigen/Core>
#include <optional>

#include "faster/data/camera.hpp"
#include "faster/data/image.hpp"
#include "faster/data/stimulus.hpp"

namespace faster::grip {

/// What a depth camera sees: a point per pixel in the camera frame [m], row-major. z is 0 where there is none.
using PointCloud = Image<Eigen::Vector3d>;

inline bool has_point(Eigen::Vector3d const& point) { return point.z() > 0; }

/// The point at depth `z` on the ray through a pixel's centre.
Eigen::Vector3d back_projected(Camera const& camera, int row, int col, double z);

/// The observed scene. A reading stands for the middle of its depth code.
PointCloud observed_cloud(Stimulus const& stimulus);

/// Thesis eq. 2.2 at a pixel that has a point p:
///   c = || sum over N of (p' - p) || / (|N| * ||p||)
/// N: the other pixels of the n x n square around it that lie in the image and have a point; n = 2 `radius` + 1. 0
/// without neighbours. The thesis's bracket leaves open whether p is subtracted once or from every neighbour: as in its
/// source (Zhang, Singh, "LOAM", RSS 2014), from every one.
double curvature(PointCloud const& cloud, int row, int col, int radius);

/// Feature of a pixel.
enum class Feature : std::uint8_t { none, planar, edge };

/// Pixels with a point: edges where the curvature is above the threshold, planar otherwise.
Image<Feature> features(PointCloud const& cloud, int neighbourhood, double threshold);

}  // namespace faster::grip
