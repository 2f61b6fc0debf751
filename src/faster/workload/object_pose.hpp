#pragma once
#include "dataflow/base/portable_math.hpp"
#include "faster/config/workload_config.hpp"
#include "faster/data/mesh.hpp"

namespace faster::workload {

constexpr double radians_per_degree = dataflow::portable::pi / 180;

/// Object to camera frame as configured: rotation about the camera's x, then y, then z axis, then the translation.
Pose configured_pose(SceneObjectConfig const& object);

}  // namespace faster::workload
