#include "poses/grip/edge_features.hpp"

#include <cmath>

namespace faster::grip {

Eigen::Vector3d back_projected(Camera const& camera, int row, int col, double z) {
    return {(col - camera.cx) / camera.fx * z, (row - camera.cy) / camera.fy * z, z};
}

PointCloud observed_cloud(Stimulus const& stimulus) {
    PointCloud cloud(stimulus.height, stimulus.width, Eigen::Vector3d::Zero());
    for (int row = 0; row < stimulus.height; ++row)
        for (int col = 0; col < stimulus.width; ++col)
            if (int const code = stimulus.observed_depth.at(row, col); code > 0)
                cloud.at(row, col) = back_projected(stimulus.posed.camera, row, col,
                                                    std::ldexp(code + 0.5, -stimulus.fraction.depth_buffer));
    return cloud;
}

double curvature(PointCloud const& cloud, int row, int col, int radius) {
    Eigen::Vector3d const& point = cloud.at(row, col);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int neighbours = 0;
    for (int r = row - radius; r <= row + radius; ++r)
        for (int c = col - radius; c <= col + radius; ++c) {
            if (!cloud.contains(r, c) || (r == row && c == col) || !has_point(cloud.at(r, c)))
                continue;
            sum += cloud.at(r, c) - point;
            ++neighbours;
        }
    return neighbours == 0 ? 0 : sum.norm() / (neighbours * point.norm());
}

Image<Feature> features(PointCloud const& cloud, int neighbourhood, double threshold) {
    Image<Feature> features(cloud.height(), cloud.width(), Feature::none);
    for (int row = 0; row < cloud.height(); ++row)
        for (int col = 0; col < cloud.width(); ++col)
            if (has_point(cloud.at(row, col)))
                features.at(row, col) =
                    curvature(cloud, row, col, neighbourhood / 2) > threshold ? Feature::edge : Feature::planar;
    return features;
}

}  // namespace faster::grip
