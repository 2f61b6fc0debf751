#include "faster/workload/depth_image.hpp"

#include <algorithm>
#include <cmath>

#include "faster/data/fixed_point.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/files/tiff_image.hpp"

namespace faster::workload {

Camera downscaled(Camera const& camera, int n) {
    return {(camera.width + n - 1) / n,
            (camera.height + n - 1) / n,
            camera.fx / n,
            camera.fy / n,
            camera.cx / n,
            camera.cy / n};
}

DepthImage downscaled(DepthImage const& depth, int n) {
    DepthImage kept((depth.height() + n - 1) / n, (depth.width() + n - 1) / n);
    for (int row = 0; row < kept.height(); ++row)
        for (int column = 0; column < kept.width(); ++column)
            kept.at(row, column) = depth.at(row * n, column * n);
    return kept;
}

DepthImage load_depth_image(std::filesystem::path const& path, double unit_m, Camera const& camera, int downscale) {
    Image<std::uint16_t> const raw = files::read_depth_counts(path);
    files::require_size(path, raw.width(), raw.height(), camera.width, camera.height, "workload.camera");
    DepthImage depth(raw.height(), raw.width());
    std::transform(raw.pixels().begin(), raw.pixels().end(), depth.pixels().begin(),
                   [unit_m](std::uint16_t count) { return unit_m * count; });
    return downscaled(depth, downscale);
}

Image<std::uint16_t> depth_codes(DepthImage const& depth, int fraction_bits) {
    Image<std::uint16_t> codes(depth.height(), depth.width());
    double const codes_per_m = std::ldexp(1.0, fraction_bits);  // a power of two: the product is exact
    std::transform(depth.pixels().begin(), depth.pixels().end(), codes.pixels().begin(), [&](double depth_m) {
        return static_cast<std::uint16_t>(std::clamp(depth_m * codes_per_m, 0.0, 1.0 * far_depth_code));
    });
    return codes;
}

}  // namespace faster::workload
