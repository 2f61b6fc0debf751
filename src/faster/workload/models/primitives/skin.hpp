#pragma once
#include <Eigen/Core>
#include <vector>

#include "faster/data/mesh.hpp"

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

/// A level super-ellipse of a loft [mm]. Exponent 2 is an ellipse, 4 to 8 a rounded rectangle.
struct Level {
    double height;
    double half_x;
    double half_y;
    double exponent = 2.0;
    double centre_x = 0.0;
};

/// The body through all levels, from bottom to top, with flat ends.
Mesh loft(std::vector<Level> const& levels, double edge_length);

/// A point of a profile: distance from the z axis and height [mm].
struct ProfilePoint {
    double radius;
    double height;
};

/// The body swept by turning a profile about the z axis. The profile starts on the axis below, runs along the outside
/// and ends on the axis above; if it comes back down inside, the body is hollow and open at the top.
Mesh revolution(std::vector<ProfilePoint> const& profile, double edge_length);

/// A cross-section on the way of a tube [mm]: across the way, half as wide sideways and half as high along `up`.
struct Station {
    Eigen::Vector3d centre;
    double half_width;
    double half_height;
    double exponent = 2.0;
};

/// The body swept along the stations. `up` must not point along the way; for a way in one plane it is the normal of
/// that plane. Joined ends make a ring.
Mesh tube(std::vector<Station> const& stations, Eigen::Vector3d const& up, double edge_length,
          Between between = Between::smooth, Ends ends = Ends::capped);

}  // namespace faster::models
