#pragma once
#include "faster/data/stimulus.hpp"

namespace faster::estimation {

/// Moves a pose so that the object's surface, as the camera would see it, lies in the readings: iterative closest
/// points, the distance of a reading from the surface's plane (Chen and Medioni, 1991), with pairs that are far apart
/// counting less or not at all. What something nearer hides thus has no say. Nor is there a step in directions of
/// which the pairs say next to nothing. A pose is given back as it was if too few readings are near, or if after moving
/// it a smaller share of the surface's points is close to a reading than before.
/// `observed`: a posed stimulus; its samples do not matter. Sums are Eigen's, which may fuse on some machines.
Pose refined_by_icp(Stimulus const& observed, Pose const& start);

}  // namespace faster::estimation
