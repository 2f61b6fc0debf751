#pragma once
#include <vector>

#include "faster/config/workload_config.hpp"
#include "faster/data/mesh.hpp"

namespace faster::workload {

/// Pose hypotheses around the true pose, as after a diffusion step of the estimator: translation off by a normal error
/// per axis, rotation by a normal angle about an axis of uniform direction through the object's origin. Sample k does
/// not depend on how many samples are drawn.
std::vector<Pose> sample_poses(Pose const& truth, SamplesConfig const& config);

}  // namespace faster::workload
