#pragma once

namespace faster {

/// Pinhole camera: u = fx * x / z + cx (column), v = fy * y / z + cy (row), pixel centres at whole numbers.
struct Camera {
    int width = 640;
    int height = 480;
    double fx = 570.34;
    double fy = 570.34;
    double cx = 319.5;
    double cy = 239.5;
};

}  // namespace faster
