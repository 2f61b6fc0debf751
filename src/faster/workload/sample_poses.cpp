#include "faster/workload/sample_poses.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/object_pose.hpp"

namespace faster::workload {
namespace {

/// Uniform on the sphere: by Archimedes, its z is uniform.
Eigen::Vector3d random_direction(Random& random) {
    double const z = 2 * random.uniform() - 1;
    double const azimuth = 2 * portable::pi * random.uniform();
    double const radius = std::sqrt(1 - z * z);
    return {radius * std::cos(azimuth), radius * std::sin(azimuth), z};
}

// One draw per statement: the order in which arguments are evaluated is open.
Eigen::Vector3d random_translation_m(Random& random, double sigma_m) {
    Eigen::Vector3d translation_m;
    translation_m.x() = sigma_m * random.normal();
    translation_m.y() = sigma_m * random.normal();
    translation_m.z() = sigma_m * random.normal();
    return translation_m;
}

Eigen::Matrix3d random_rotation(Random& random, double sigma_deg) {
    Eigen::Vector3d const axis = random_direction(random);
    double const angle = sigma_deg * radians_per_degree * random.normal();
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
}

}  // namespace

std::vector<Pose> sample_poses(Pose const& truth, SamplesConfig const& config) {
    Random random(config.seed);
    std::vector<Pose> poses(static_cast<std::size_t>(config.count));
    for (Pose& pose : poses) {
        pose.translation = truth.translation + random_translation_m(random, config.translation_sigma_m);
        pose.rotation = random_rotation(random, config.rotation_sigma_deg) * truth.rotation;
    }
    return poses;
}

}  // namespace faster::workload
