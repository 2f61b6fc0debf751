#include "faster/workload/files/polygon_cutter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace faster::files {
namespace {

using Points = std::vector<Eigen::Vector2d>;

/// Newell's: its length is twice the area of a flat polygon.
Eigen::Vector3d mean_normal(std::vector<Eigen::Vector3d> const& corners) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        normal += (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
    return normal;
}

/// Without the coordinate along which the normal is longest, so that the corners run counter-clockwise. No coordinate
/// is rounded.
Points shadow(std::vector<Eigen::Vector3d> const& corners) {
    Eigen::Vector3d const normal = mean_normal(corners);
    Eigen::Vector3d const size = normal.cwiseAbs();
    int dropped = 2;
    if (size.x() > size.y())
        dropped = size.x() > size.z() ? 0 : 2;
    else if (size.y() > size.z())
        dropped = 1;
    int first = (dropped + 1) % 3, second = (dropped + 2) % 3;
    if (normal[dropped] < 0)
        std::swap(first, second);
    Points points;
    points.reserve(corners.size());
    for (Eigen::Vector3d const& corner : corners)
        points.emplace_back(corner[first], corner[second]);
    return points;
}

/// Twice the area of a triangle; positive if it runs counter-clockwise.
double turn(Eigen::Vector2d const& a, Eigen::Vector2d const& b, Eigen::Vector2d const& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Cuts off one corner after the other. Polygons that break the rules of outlines have no ears at some point: the rules
/// are then relaxed for one cut, so that every polygon ends.
class EarCutter {
  public:
    explicit EarCutter(Points points)
        : points_(std::move(points)),
          next_(points_.size()),
          previous_(points_.size()),
          left_(points_.size()),
          is_in_the_way_(points_.size(), false) {
        std::size_t const n = points_.size();
        for (std::size_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            previous_[i] = (i + n - 1) % n;
        }
    }

    std::vector<CornerTriple> triangles() {
        std::size_t corner = cut_off_spikes(), refused = 0;
        for (std::size_t i = 0; i < left_; ++i, corner = next_[corner])
            note(corner);
        auto rule = Rule::clear;
        while (left_ > 3) {
            if (may_go(corner, rule)) {
                cut_off(corner);
                note(previous_[corner]);  // where the rules were relaxed, a convex one may be concave now
                note(next_[corner]);
                refused = 0;
                rule = Rule::clear;
            } else if (++refused == left_) {
                refused = 0;
                rule = rule == Rule::clear ? Rule::touched : rule == Rule::touched ? Rule::convex : Rule::any;
            }
            corner = next_[corner];
        }
        CornerTriple last{corner, next_[corner], previous_[corner]};
        std::rotate(last.begin(), std::min_element(last.begin(), last.end()), last.end());
        cut_.push_back(last);
        return cut_;
    }

  private:
    /// Which corners may go.
    enum class Rule {
        clear,    ///< those whose triangle has no other corner inside or on its sides, and straight ones
        touched,  ///< those whose triangle has none inside
        convex,   ///< any convex one
        any
    };

    double turn_at(std::size_t corner) const {
        return turn(points_[previous_[corner]], points_[corner], points_[next_[corner]]);
    }

    /// Only corners that are not convex can be inside of what another cuts off. A straight one may be concave later: it
    /// may be one of two at the same place.
    void note(std::size_t corner) {
        if (is_in_the_way_[corner] || turn_at(corner) > 0)
            return;
        is_in_the_way_[corner] = true;
        in_the_way_.push_back(corner);
    }

    void cut_off(std::size_t corner) {
        cut_.push_back({previous_[corner], corner, next_[corner]});
        next_[previous_[corner]] = next_[corner];
        previous_[next_[corner]] = previous_[corner];
        --left_;
    }

    /// A spike has no width: the outline comes back on the line on which it went to its tip. Its foot looks like a
    /// convex corner, whose triangle would reach to the tip. Returns the corner after the last that was looked at.
    std::size_t cut_off_spikes() {
        std::size_t corner = 0, passed = 0;
        while (left_ > 3 && passed < left_) {
            if (is_tip(corner)) {
                cut_off(corner);
                corner = previous_[corner];  // may be a tip now
                passed = 0;
            } else {
                corner = next_[corner];
                ++passed;
            }
        }
        return corner;
    }

    /// Or one of two corners at the same place. A spike in steps that does not lie along an axis is straight but for
    /// the rounding of coordinates, which are often those of 32-bit floats.
    bool is_tip(std::size_t corner) const {
        constexpr double narrow = 1e-6;  // radians
        Eigen::Vector2d const there = points_[previous_[corner]] - points_[corner],
                              back = points_[next_[corner]] - points_[corner];
        return there.dot(back) >= 0 && std::abs(turn_at(corner)) <= narrow * there.norm() * back.norm();
    }

    bool may_go(std::size_t corner, Rule rule) const {
        Eigen::Vector2d const &a = points_[previous_[corner]], &b = points_[corner], &c = points_[next_[corner]];
        double const turned = turn(a, b, c);
        if (rule == Rule::any || turned == 0)
            return true;
        if (turned < 0)
            return false;
        return rule == Rule::convex || std::none_of(in_the_way_.begin(), in_the_way_.end(), [&](std::size_t other) {
                   Eigen::Vector2d const& point = points_[other];
                   if (point == a || point == b || point == c)
                       return false;
                   double const nearest = std::min({turn(a, b, point), turn(b, c, point), turn(c, a, point)});
                   return rule == Rule::clear ? nearest >= 0 : nearest > 0;
               });
    }

    Points points_;
    std::vector<std::size_t> next_, previous_;
    std::size_t left_;  ///< corners that are not cut off
    std::vector<CornerTriple> cut_;
    std::vector<std::size_t> in_the_way_;
    std::vector<bool> is_in_the_way_;
};

double angle_between(Eigen::Vector3d const& a, Eigen::Vector3d const& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// At a concave corner the two sides are more than a half turn apart, measured across the diagonal. Beside it they may
/// be, too, where the diagonal runs outside: then one of its triangles is turned over.
std::vector<CornerTriple> cut_quadrilateral(std::vector<Eigen::Vector3d> const& corners) {
    constexpr double half_turn = 3.14159266;  // a little more: straight corners are not concave, however they round
    Eigen::Vector3d const normal = mean_normal(corners);
    std::size_t start = 0;
    for (std::size_t i = 4; i-- > 0;) {
        auto const side = [&](std::size_t steps) -> Eigen::Vector3d { return corners[(i + steps) % 4] - corners[i]; };
        bool const is_inside = side(1).cross(side(2)).dot(normal) >= 0 && side(2).cross(side(3)).dot(normal) >= 0;
        if (is_inside && angle_between(side(1), side(2)) + angle_between(side(2), side(3)) > half_turn)
            start = i;
    }
    return {{start, (start + 1) % 4, (start + 2) % 4}, {start, (start + 2) % 4, (start + 3) % 4}};
}

}  // namespace

std::vector<CornerTriple> cut_polygon(std::vector<Eigen::Vector3d> const& corners) {
    if (corners.size() == 3)
        return {{0, 1, 2}};
    if (corners.size() == 4)
        return cut_quadrilateral(corners);
    return EarCutter(shadow(corners)).triangles();
}

}  // namespace faster::files
