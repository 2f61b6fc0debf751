#include "reference/grip/inlier_ratio.hpp"

namespace faster::grip {

PoseScore score(FeatureCloud const& rendered, FeatureCloud const& observed, double distance) {
    PoseScore score;
    for (std::size_t i = 0; i < rendered.points.pixels().size(); ++i) {
        Feature const feature = rendered.features.pixels()[i];
        if (feature == Feature::none)
            continue;
        Eigen::Vector3d const& seen = observed.points.pixels()[i];
        bool const agrees = has_point(seen) && is_inlier(rendered.points.pixels()[i], seen, distance);
        InlierCount& of_feature = feature == Feature::edge ? score.edge : score.planar;
        ++score.raw.points;
        ++of_feature.points;
        score.raw.inliers += agrees ? 1U : 0U;
        of_feature.inliers += agrees && feature == observed.features.pixels()[i] ? 1U : 0U;
    }
    return score;
}

}  // namespace faster::grip
