#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

#include "faster/data/image.hpp"

namespace faster {

/// Sum of points, and how many they are. A pixel without point is the empty sum.
struct PointSum {
    double x = 0, y = 0, z = 0, points = 0;

    void add(PointSum const& other, double sign) {
        x += sign * other.x;
        y += sign * other.y;
        z += sign * other.z;
        points += sign * other.points;
    }
};

/// Slides over [0, size): `add(i, 1)` for what comes within `radius` of a place and `add(i, -1)` for what leaves it,
/// then `visit` with the place.
template <class Add, class Visit> void slide(int size, int radius, Add const& add, Visit const& visit) {
    for (int i = 0; i < std::min(radius, size); ++i)
        add(i, 1);
    for (int i = 0; i < size; ++i) {
        if (i + radius < size)
            add(i + radius, 1);
        if (i - radius - 1 >= 0)
            add(i - radius - 1, -1);
        visit(i);
    }
}

/// Calls `visit(row, col, point, square)` for every pixel of an image, row by row: its point and the sum of all points
/// at most `radius` rows and columns away, its own included. `point_at(row, col)` is asked once per pixel.
template <class PointAt, class Visit>
void for_each_square(int height, int width, int radius, PointAt const& point_at, Visit const& visit) {
    Image<PointSum> kept(std::min(2 * radius + 2, height), width);  // the rows that are yet to leave the sums
    std::vector<PointSum> columns(static_cast<std::size_t>(width));
    auto const points_of = [&](int row) { return kept.row(row % kept.height()); };
    auto const add_row = [&](int row, double sign) {
        PointSum* const points = points_of(row);
        for (int col = 0; col < width; ++col) {
            if (sign > 0)
                points[col] = point_at(row, col);
            columns[static_cast<std::size_t>(col)].add(points[col], sign);
        }
    };
    slide(height, radius, add_row, [&](int row) {
        PointSum square;
        auto const add_column = [&](int col, double sign) { square.add(columns[static_cast<std::size_t>(col)], sign); };
        slide(width, radius, add_column, [&](int col) { visit(row, col, points_of(row)[col], square); });
    });
}

/// Thesis eq. 2.2, c = || sum over N of (p' - p) || / (|N| * ||p||) > threshold, for a point and the sum of the square
/// around it. The point itself adds nothing to the sum of differences and is no neighbour. Compares squares, to do
/// without roots.
inline bool is_edge(PointSum const& point, PointSum const& square, double threshold) {
    double const neighbours = square.points - 1;
    if (point.points == 0 || neighbours < 1)
        return false;
    double const dx = square.x - square.points * point.x;
    double const dy = square.y - square.points * point.y;
    double const dz = square.z - square.points * point.z;
    double const limit = threshold * neighbours;
    double const distance_squared = point.x * point.x + point.y * point.y + point.z * point.z;
    return dx * dx + dy * dy + dz * dz > limit * limit * distance_squared;
}

}  // namespace faster
