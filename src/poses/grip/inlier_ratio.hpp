#pragma once
#include <cstdint>

#include "poses/grip/edge_features.hpp"

namespace faster::grip {

/// Points of one kind, and how many of them agree with the observation.
struct InlierCount {
    std::uint64_t points = 0;   ///< |r| of eq. 2.3
    std::uint64_t inliers = 0;  ///< its sum

    /// I of eq. 2.3; 0 without points.
    double ratio() const { return points == 0 ? 0 : static_cast<double>(inliers) / static_cast<double>(points); }
    void count(bool agrees) {
        ++points;
        inliers += agrees ? 1U : 0U;
    }
};

/// Thesis eq. 2.1: whether two points are less than `distance` [m] apart.
inline bool is_inlier(Eigen::Vector3d const& a, Eigen::Vector3d const& b, double distance) {
    return (a - b).norm() < distance;
}

/// Pixels of the image in [left, right) x [top, bottom); by default none.
struct PixelArea {
    double left = 0, top = 0, right = 0, bottom = 0;
    bool contains(int row, int col) const { return row >= top && row < bottom && col >= left && col < right; }
};

/// What a rendered pose has in common with the scene.
struct PoseScore {
    InlierCount raw;     ///< all rendered points
    InlierCount edge;    ///< rendered edges; an inlier needs an observed edge at its pixel
    InlierCount planar;  ///< the same of planar points
    InlierCount in_box;  ///< the rendered points in the box in which the object was found

    /// W of eq. 2.4 without the parts that come from the network. The thesis gives no weights: equal ones.
    double weight() const { return (raw.ratio() + edge.ratio() + planar.ratio()) / 3; }

    /// One more rendered point, and what is observed at its pixel (`seen`: without depth for nothing).
    void count(Feature feature, Eigen::Vector3d const& point, Feature seen_feature, Eigen::Vector3d const& seen,
               double distance, bool is_in_box);
};

/// A point cloud with its features.
struct FeatureCloud {
    PointCloud points;
    Image<Feature> features;
};

}  // namespace faster::grip
