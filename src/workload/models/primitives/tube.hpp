#pragma once
#include <Eigen/Core>
#include <vector>

#include "common/mesh.hpp"
#include "workload/models/primitives/skin.hpp"

namespace faster::models {

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
