#pragma once
#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <vector>

namespace faster::files {

/// Three corners of a polygon, by number.
using CornerTriple = std::array<std::size_t, 3>;

/// Cuts a polygon of n corners, n >= 3, into n - 2 triangles that together cover what it covers, with its orientation:
/// concave polygons, corners on a straight line and points that are passed twice (a hole that is tied to the outline)
/// included. A polygon that is not flat is cut as its shadow along its mean normal. What an outline that crosses itself
/// covers is not defined: it gets triangles all the same.
///
/// The order of cutting is part of the results of a run: a quadrilateral is a fan from its concave corner or its first
/// one, any other convex polygon a fan from its last corner.
std::vector<CornerTriple> cut_polygon(std::vector<Eigen::Vector3d> const& corners);

}  // namespace faster::files
