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

double Curvature::operator()(PointCloud const& cloud, int row, int col) const {
    Eigen::Vector3d const& point = cloud.at(row, col);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int neighbours = 0;
    for (int r = row - radius_; r <= row + radius_; ++r)
        for (int c = col - radius_; c <= col + radius_; ++c) {
            if (!cloud.contains(r, c) || (r == row && c == col))
                continue;
            bool const is_bare = !has_point(cloud.at(r, c));
            if (is_bare && background_ == nullptr)
                continue;
            sum += (is_bare ? *background_ : cloud).at(r, c) - point;
            ++neighbours;
        }
    return neighbours == 0 ? 0 : sum.norm() / (neighbours * point.norm());
}

PointCloud background_cloud(Camera const& camera, double z) {
    PointCloud cloud(camera.height, camera.width, Eigen::Vector3d::Zero());
    for (int row = 0; row < camera.height; ++row)
        for (int col = 0; col < camera.width; ++col)
            cloud.at(row, col) = back_projected(camera, row, col, z);
    return cloud;
}

Image<Feature> features(PointCloud const& cloud, Curvature const& curvature, double threshold) {
    Image<Feature> features(cloud.height(), cloud.width(), Feature::none);
    for (int row = 0; row < cloud.height(); ++row)
        for (int col = 0; col < cloud.width(); ++col)
            if (has_point(cloud.at(row, col)))
                features.at(row, col) = curvature(cloud, row, col) > threshold ? Feature::edge : Feature::planar;
    return features;
}

}  // namespace faster::grip
