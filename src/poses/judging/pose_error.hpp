#pragma once
#include <Eigen/Core>
#include <vector>

#include "faster/data/camera.hpp"
#include "faster/data/mesh.hpp"

namespace faster::poses {

using Points = std::vector<Eigen::Vector3d>;

/// The mean distance from a point of `from` to the nearest of `to`, which must not be empty.
double mean_nearest_distance(Points const& from, Points const& to);

/// The largest distance from a point of `from` to the nearest of `to`, which must not be empty.
double largest_nearest_distance(Points const& from, Points const& to);

// How far an estimated pose is from the true one, by what it does to the points of the model [m]. Points must not be
// empty. ADD and ADD-S: Hinterstoisser et al., ACCV 2012, as in the toolbox of YCB-Video; MSSD: Hodan et al., ECCV
// 2020.

/// ADD: the mean distance between a point where it is estimated and where it is.
double add(Points const& points, Pose const& estimate, Pose const& truth);

/// ADD-S: the mean distance from a point where it is to the nearest estimated one, whichever that is.
double add_s(Points const& points, Pose const& estimate, Pose const& truth);

/// MSSD: the largest distance between a point where it is estimated and where it is; the smallest such of all
/// `symmetries`, which map the model to itself and include the identity.
double mssd(Points const& points, std::vector<Pose> const& symmetries, Pose const& estimate, Pose const& truth);

/// MSPD: the same by where points are in the image [px]; infinite if a point has no place in it.
double mspd(Points const& points, std::vector<Pose> const& symmetries, Pose const& estimate, Pose const& truth,
            Camera const& camera);

}  // namespace faster::poses
