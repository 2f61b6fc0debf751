#pragma once
#include <vector>

#include "common/mesh.hpp"

namespace faster::models {

/// A point of a profile: distance from the z axis and height [mm].
struct ProfilePoint {
    double radius;
    double height;
};

/// The body swept by turning a profile about the z axis. The profile starts on the axis below, runs along the outside
/// and ends on the axis above; if it comes back down inside, the body is hollow and open at the top.
Mesh revolution(std::vector<ProfilePoint> const& profile, double edge_length);

}  // namespace faster::models
