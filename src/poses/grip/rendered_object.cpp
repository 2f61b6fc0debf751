#include "poses/grip/rendered_object.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

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

/// Sum of points.
struct PointSum {
    double x = 0, y = 0, z = 0;

    void add(PointSum const& other, double sign) {
        x += sign * other.x;
        y += sign * other.y;
        z += sign * other.z;
    }
};

/// Points of the object's box and `radius` pixels around it, those of the background where nothing is drawn; nothing
/// outside the image.
class Surroundings {
  public:
    Surroundings(RenderedObject const& object, Camera const& camera, int radius, double background)
        : top_(std::max(0, object.first_row - radius)),
          left_(std::max(0, object.first_col - radius)),
          points_(std::min(camera.height, object.first_row + object.depth.height() + radius) - top_,
                  std::min(camera.width, object.first_col + object.depth.width() + radius) - left_) {
        for (int row = 0; row < points_.height(); ++row)
            for (int col = 0; col < points_.width(); ++col) {
                int const r = row + top_ - object.first_row, c = col + left_ - object.first_col;
                double const drawn = object.depth.contains(r, c) ? object.depth.at(r, c) : 0;
                Eigen::Vector3d const p =
                    back_projected(camera, row + top_, col + left_, drawn > 0 ? drawn : background);
                points_.at(row, col) = {p.x(), p.y(), p.z()};
            }
    }

    Image<PointSum> const& points() const { return points_; }
    int top() const { return top_; }
    int left() const { return left_; }

  private:
    int top_;
    int left_;
    Image<PointSum> points_;
};

/// Sums over 2 * radius + 1 rows (then columns) around each, of those that there are.
Image<PointSum> summed_down(Image<PointSum> const& points, int radius) {
    Image<PointSum> sums(points.height(), points.width());
    std::vector<PointSum> running(static_cast<std::size_t>(points.width()));
    auto const add_row = [&](int row, double sign) {
        if (row < 0 || row >= points.height())
            return;
        for (std::size_t col = 0; col < running.size(); ++col)
            running[col].add(points.row(row)[col], sign);
    };
    for (int row = 0; row < radius; ++row)
        add_row(row, 1);
    for (int row = 0; row < points.height(); ++row) {
        add_row(row + radius, 1);
        add_row(row - radius - 1, -1);
        std::copy(running.begin(), running.end(), sums.row(row));
    }
    return sums;
}

Image<PointSum> summed_across(Image<PointSum> const& columns, int radius) {
    Image<PointSum> sums(columns.height(), columns.width());
    for (int row = 0; row < columns.height(); ++row) {
        PointSum running;
        PointSum const* const from = columns.row(row);
        for (int col = 0; col < std::min(radius, columns.width()); ++col)
            running.add(from[col], 1);
        for (int col = 0; col < columns.width(); ++col) {
            if (col + radius < columns.width())
                running.add(from[col + radius], 1);
            if (col - radius - 1 >= 0)
                running.add(from[col - radius - 1], -1);
            sums.at(row, col) = running;
        }
    }
    return sums;
}

/// How many pixels of [at - radius, at + radius] are in [0, size).
int pixels_around(int at, int radius, int size) {
    return std::min(size - 1, at + radius) - std::max(0, at - radius) + 1;
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

/// The own point is part of the sum, to which it adds nothing, and none of the neighbours.
Image<Feature> features(RenderedObject const& object, Camera const& camera, int neighbourhood, double threshold,
                        double background) {
    Image<Feature> features(object.depth.height(), object.depth.width(), Feature::none);
    if (features.empty())
        return features;
    int const radius = neighbourhood / 2;
    Surroundings const around(object, camera, radius, background);
    Image<PointSum> const sums = summed_across(summed_down(around.points(), radius), radius);
    for (int row = 0; row < features.height(); ++row)
        for (int col = 0; col < features.width(); ++col) {
            if (object.depth.at(row, col) == 0)
                continue;
            int const image_row = row + object.first_row, image_col = col + object.first_col;
            PointSum const& p = around.points().at(image_row - around.top(), image_col - around.left());
            PointSum sum = sums.at(image_row - around.top(), image_col - around.left());
            double const pixels =
                pixels_around(image_row, radius, camera.height) * pixels_around(image_col, radius, camera.width);
            sum.add(p, -pixels);
            double const limit = threshold * (pixels - 1);
            bool const is_edge =
                sum.x * sum.x + sum.y * sum.y + sum.z * sum.z > limit * limit * (p.x * p.x + p.y * p.y + p.z * p.z);
            features.at(row, col) = is_edge ? Feature::edge : Feature::planar;
        }
    return features;
}

}  // namespace faster::grip
