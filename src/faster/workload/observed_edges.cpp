#include "faster/workload/observed_edges.hpp"

#include <algorithm>
#include <vector>

namespace faster::workload {
namespace {

/// Sum of points, and how many they are. A pixel without reading is the empty sum.
struct PointSum {
    double x = 0, y = 0, z = 0, points = 0;

    PointSum& operator+=(PointSum const& other) { return add(other, 1); }
    PointSum& operator-=(PointSum const& other) { return add(other, -1); }

  private:
    PointSum& add(PointSum const& other, double sign) {
        x += sign * other.x;
        y += sign * other.y;
        z += sign * other.z;
        points += sign * other.points;
        return *this;
    }
};

/// The points of a depth image row by row, from the top. The last `kept` rows are at hand.
class Cloud {
  public:
    Cloud(DepthImage const& depth, Camera const& camera, int kept)
        : depth_(depth), camera_(camera), rows_(kept, depth.width()) {}

    PointSum const* row(int row) const { return rows_.row(row % rows_.height()); }

    PointSum const* add_row(int row) {
        PointSum* const points = rows_.row(row % rows_.height());
        double const y_per_z = (row - camera_.cy) / camera_.fy;
        for (int column = 0; column < depth_.width(); ++column) {
            double const z = depth_.at(row, column);
            points[column] = z > 0 ? PointSum{(column - camera_.cx) / camera_.fx * z, y_per_z * z, z, 1} : PointSum();
        }
        return points;
    }

  private:
    DepthImage const& depth_;
    Camera const& camera_;
    Image<PointSum> rows_;
};

/// `square` includes the point itself, which adds nothing to the sum of differences but one to the count. Compares
/// squares, to do without roots.
bool is_edge(PointSum const& point, PointSum const& square, double threshold) {
    double const neighbours = square.points - 1;
    if (point.points == 0 || neighbours < 1) {
        return false;
    }
    double const dx = square.x - square.points * point.x;
    double const dy = square.y - square.points * point.y;
    double const dz = square.z - square.points * point.z;
    double const limit = threshold * neighbours;
    double const distance_squared = point.x * point.x + point.y * point.y + point.z * point.z;
    return dx * dx + dy * dy + dz * dz > limit * limit * distance_squared;
}

/// Sums over the rows within `radius` of `row`, per column, sliding down with it.
class ColumnSums {
  public:
    ColumnSums(DepthImage const& depth, Camera const& camera, int radius)
        : cloud_(depth, camera, std::min(2 * radius + 2, depth.height())),
          height_(depth.height()),
          radius_(radius),
          sums_(static_cast<std::size_t>(depth.width())) {
        for (int row = 0; row < std::min(radius, height_); ++row) {
            add_row(row);
        }
    }

    PointSum const* points(int row) const { return cloud_.row(row); }
    std::vector<PointSum> const& slide_to(int row) {
        if (row + radius_ < height_) {
            add_row(row + radius_);
        }
        if (row - radius_ - 1 >= 0) {
            PointSum const* const leaving = cloud_.row(row - radius_ - 1);
            for (std::size_t column = 0; column < sums_.size(); ++column) {
                sums_[column] -= leaving[column];
            }
        }
        return sums_;
    }

  private:
    void add_row(int row) {
        PointSum const* const entering = cloud_.add_row(row);
        for (std::size_t column = 0; column < sums_.size(); ++column) {
            sums_[column] += entering[column];
        }
    }

    Cloud cloud_;
    int height_;
    int radius_;
    std::vector<PointSum> sums_;
};

void mark_row(PointSum const* points, std::vector<PointSum> const& column_sums, int radius, double threshold,
              std::uint8_t* edges) {
    int const width = static_cast<int>(column_sums.size());
    PointSum square;
    for (int column = 0; column < std::min(radius, width); ++column) {
        square += column_sums[static_cast<std::size_t>(column)];
    }
    for (int column = 0; column < width; ++column) {
        int const entering = column + radius;
        if (entering < width) {
            square += column_sums[static_cast<std::size_t>(entering)];
        }
        int const leaving = column - radius - 1;
        if (leaving >= 0) {
            square -= column_sums[static_cast<std::size_t>(leaving)];
        }
        edges[column] = is_edge(points[column], square, threshold) ? 1 : 0;
    }
}

}  // namespace

Image<std::uint8_t> observed_edges(DepthImage const& depth, Camera const& camera, ObservedEdgesConfig const& config) {
    Image<std::uint8_t> edges(depth.height(), depth.width());
    int const radius = config.neighbourhood / 2;
    ColumnSums column_sums(depth, camera, radius);
    for (int row = 0; row < depth.height(); ++row) {
        std::vector<PointSum> const& sums = column_sums.slide_to(row);
        mark_row(column_sums.points(row), sums, radius, config.threshold, edges.row(row));
    }
    return edges;
}

}  // namespace faster::workload
