#include "faster/workload/object_pose.hpp"

#include <Eigen/Geometry>

namespace faster::workload {

Pose configured_pose(SceneObjectConfig const& object) {
    auto const about = [&](int axis) {
        double const degrees = object.rotation_deg[static_cast<std::size_t>(axis)];
        return Eigen::AngleAxisd(degrees * radians_per_degree, Eigen::Vector3d::Unit(axis)).toRotationMatrix();
    };
    Pose pose;
    pose.rotation = about(2) * about(1) * about(0);
    pose.translation = Eigen::Vector3d(object.translation_m[0], object.translation_m[1], object.translation_m[2]);
    return pose;
}

}  // namespace faster::workload
