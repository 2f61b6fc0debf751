#pragma once
#include <Eigen/Core>
#include <vector>

#include "common/mesh.hpp"

namespace faster::models {

/// One cross-section of a body: a super-ellipse around `centre` with the half axes `u` and `v` [mm]. Exponent 2 is an
/// ellipse, 4 to 8 a rectangle with ever sharper corners. u = v = 0 is a pole: the body closes in a point.
struct Section {
    Eigen::Vector3d centre;
    Eigen::Vector3d u;
    Eigen::Vector3d v;
    double exponent = 2.0;
};

enum class Between { straight, smooth };  ///< how sections follow each other: lines, or a spline through all of them
enum class Ends { capped, joined };       ///< flat lids on both ends, or the last section leads back to the first

/// Stretches a closed surface over the sections, in order. It faces outwards if u x v points along the way forward
/// where the body goes forward; a body that turns back inside itself (a mug) keeps its wall between the two surfaces.
///   edge_length  aimed-at length of the triangle edges [mm]; intermediate sections are added to reach it, and no
///   section has
///                fewer than eight corners
/// Every given section appears in the mesh, so sharp features stay sharp.
Mesh skin(std::vector<Section> const& sections, double edge_length, Between between = Between::straight,
          Ends ends = Ends::capped);

}  // namespace faster::models
