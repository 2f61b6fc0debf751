#include "poses/grip/inlier_ratio.hpp"

namespace faster::grip {

void PoseScore::count(Feature feature, Eigen::Vector3d const& point, Feature seen_feature, Eigen::Vector3d const& seen,
                      double distance, bool is_in_box) {
    bool const agrees = has_point(seen) && is_inlier(point, seen, distance);
    raw.count(agrees);
    (feature == Feature::edge ? edge : planar).count(agrees && feature == seen_feature);
    if (is_in_box)
        in_box.count(agrees);
}

}  // namespace faster::grip
