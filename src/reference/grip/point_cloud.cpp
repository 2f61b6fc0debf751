#include "reference/grip/point_cloud.hpp"

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

}  // namespace faster::grip
