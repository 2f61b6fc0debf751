#pragma once
#include <Eigen/Core>
#include <vector>

namespace faster::poses {

using Points = std::vector<Eigen::Vector3d>;

/// The mean distance from a point of `from` to the nearest of `to`, which must not be empty.
double mean_nearest_distance(Points const& from, Points const& to);

}  // namespace faster::poses
