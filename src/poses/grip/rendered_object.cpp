#include "poses/grip/rendered_object.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "faster/data/square_sums.hpp"

namespace faster::grip {

namespace {

/// A corner in the image [px], and 1 / z, which is linear there.
struct Corner {
    double col = 0;
    double row = 0;
    double inverse_z = 0;  ///< 0: too near
};

std::vector<Corner> projected(Mesh const& mesh, Pose const& pose, Camera const& camera, double nearest_m) {
    std::vector<Corner> corners;
    corners.reserve(mesh.vertices.size());
    for (Eigen::Vector3d const& vertex : mesh.vertices) {
        Eigen::Vector3d const p = pose.rotation * vertex + pose.translation;
        if (p.z() < nearest_m) {
            corners.push_back({});
            continue;
        }
        double const inverse = 1 / p.z();
        corners.push_back({camera.fx * p.x() * inverse + camera.cx, camera.fy * p.y() * inverse + camera.cy, inverse});
    }
    return corners;
}

/// Pixels whose centres lie in [low, high], as far as they are in [0, size). Corners are often made to lie on centres.
struct PixelRange {
    PixelRange(double low, double high, int size)
        : first(static_cast<int>(std::clamp(std::ceil(low - tolerance), 0.0, 1.0 * size))),
          last(static_cast<int>(std::clamp(std::floor(high + tolerance), -1.0, size - 1.0))) {}
    static constexpr double tolerance = 1e-9;
    int first;
    int last;
    int length() const { return std::max(0, last - first + 1); }
};

RenderedObject empty_object(std::vector<Corner> const& corners, Camera const& camera) {
    double left = camera.width, top = camera.height, right = -1, bottom = -1;
    for (Corner const& corner : corners) {
        if (corner.inverse_z == 0)
            continue;
        left = std::min(left, corner.col);
        right = std::max(right, corner.col);
        top = std::min(top, corner.row);
        bottom = std::max(bottom, corner.row);
    }
    PixelRange const rows(top, bottom, camera.height), cols(left, right, camera.width);
    return {rows.first, cols.first, Image<double>(rows.length(), cols.length())};
}

/// Where a row crosses one side of a triangle, if it does.
void widen(Corner const& a, Corner const& b, double row, double& left, double& right) {
    if (std::min(a.row, b.row) > row + PixelRange::tolerance || std::max(a.row, b.row) < row - PixelRange::tolerance)
        return;
    if (a.row == b.row) {
        left = std::min({left, a.col, b.col});
        right = std::max({right, a.col, b.col});
        return;
    }
    double const share = std::clamp((row - a.row) / (b.row - a.row), 0.0, 1.0);
    double const col = a.col + share * (b.col - a.col);
    left = std::min(left, col);
    right = std::max(right, col);
}

/// `inverse`: the largest 1 / z of each pixel so far, 0 for none.
void draw(Corner const& a, Corner const& b, Corner const& c, RenderedObject const& box, Image<double>& inverse) {
    double const area = (b.col - a.col) * (c.row - a.row) - (c.col - a.col) * (b.row - a.row);
    if (area == 0)
        return;
    double const per_col =
        ((b.inverse_z - a.inverse_z) * (c.row - a.row) - (c.inverse_z - a.inverse_z) * (b.row - a.row)) / area;
    double const per_row =
        ((c.inverse_z - a.inverse_z) * (b.col - a.col) - (b.inverse_z - a.inverse_z) * (c.col - a.col)) / area;
    auto const [top, bottom] = std::minmax({a.row, b.row, c.row});
    PixelRange const rows(top - box.first_row, bottom - box.first_row, inverse.height());
    for (int r = rows.first; r <= rows.last; ++r) {
        double const row = r + box.first_row;
        double left = 1e300, right = -1e300;
        widen(a, b, row, left, right);
        widen(b, c, row, left, right);
        widen(c, a, row, left, right);
        PixelRange const cols(left - box.first_col, right - box.first_col, inverse.width());
        double* const pixels = inverse.row(r);
        double const at_zero = a.inverse_z + per_row * (row - a.row) + per_col * (box.first_col - a.col);
        for (int col = cols.first; col <= cols.last; ++col)
            pixels[col] = std::max(pixels[col], at_zero + per_col * col);
    }
}

}  // namespace

RenderedObject render(Mesh const& mesh, Pose const& pose, Camera const& camera, double nearest_m) {
    std::vector<Corner> const corners = projected(mesh, pose, camera, nearest_m);
    RenderedObject object = empty_object(corners, camera);
    if (object.depth.empty())
        return object;
    for (auto const& face : mesh.faces) {
        Corner const &a = corners[face[0]], &b = corners[face[1]], &c = corners[face[2]];
        if (a.inverse_z > 0 && b.inverse_z > 0 && c.inverse_z > 0)
            draw(a, b, c, object, object.depth);
    }
    for (double& pixel : object.depth.pixels())
        pixel = pixel > 0 ? 1 / pixel : 0;
    return object;
}

Image<Feature> features(RenderedObject const& object, Camera const& camera, int neighbourhood, double threshold,
                        double background) {
    Image<Feature> features(object.depth.height(), object.depth.width(), Feature::none);
    if (features.empty())
        return features;
    // What the squares around the object's pixels reach in the image, counted from the first pixel of the object's box.
    int const radius = neighbourhood / 2;
    int const top = -std::min(radius, object.first_row), left = -std::min(radius, object.first_col);
    int const bottom = std::min(camera.height - object.first_row, features.height() + radius);
    int const right = std::min(camera.width - object.first_col, features.width() + radius);
    auto const depth_at = [&](int row, int col) {
        return object.depth.contains(row, col) ? object.depth.at(row, col) : 0;
    };
    auto const point_at = [&](int row, int col) {
        double const drawn = depth_at(row + top, col + left);
        Eigen::Vector3d const p = back_projected(camera, row + top + object.first_row, col + left + object.first_col,
                                                 drawn > 0 ? drawn : background);
        return PointSum{p.x(), p.y(), p.z(), 1};
    };
    for_each_square(bottom - top, right - left, radius, point_at,
                    [&](int row, int col, PointSum const& point, PointSum const& square) {
                        if (depth_at(row + top, col + left) != 0)
                            features.at(row + top, col + left) =
                                is_edge(point, square, threshold) ? Feature::edge : Feature::planar;
                    });
    return features;
}

}  // namespace faster::grip
