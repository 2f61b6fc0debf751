#include "faster/workload/files/polygon_cutter.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>
#include <random>

#include "dataflow/base/portable_math.hpp"
#include "faster/dataflow_names.hpp"

namespace polygon_cutter_test {

using faster::files::CornerTriple;
using faster::files::cut_polygon;
using Corners = std::vector<Eigen::Vector3d>;

Corners flat(std::vector<std::array<double, 2>> const& points) {
    Corners corners;
    for (auto const& point : points)
        corners.emplace_back(point[0], point[1], 0);
    return corners;
}

/// Newell's vector: half its length is the area of a flat polygon.
Eigen::Vector3d normal_of(Corners const& corners) {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 0; i < corners.size(); ++i)
        normal += corners[i].cross(corners[(i + 1) % corners.size()]);
    return normal;
}

/// The triangles cover the polygon and nothing else: all of them turn as it does, and their areas add up to its own.
void check_cover(Corners const& corners) {
    std::vector<CornerTriple> const triangles = cut_polygon(corners);
    REQUIRE(triangles.size() == corners.size() - 2);
    Eigen::Vector3d const normal = normal_of(corners);
    double const area = normal.norm();
    double sum = 0, least = 0;
    for (CornerTriple const& triangle : triangles) {
        double const turned =
            normal_of({corners[triangle[0]], corners[triangle[1]], corners[triangle[2]]}).dot(normal) / area;
        sum += std::abs(turned);
        least = std::min(least, turned);
    }
    CHECK(least >= -1e-9 * area);
    CHECK(sum == Approx(area).epsilon(1e-9));
}

/// Whichever corner the polygon begins with, seen from either side and however it lies in space.
void check_cover_from_all_corners(Corners corners) {
    Eigen::Matrix3d const turned = (Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())).toRotationMatrix();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        CAPTURE(k);
        check_cover(corners);
        check_cover({corners.rbegin(), corners.rend()});
        Corners in_space;
        for (Eigen::Vector3d const& corner : corners)
            in_space.emplace_back(turned * corner + Eigen::Vector3d(3, -2, 5));
        check_cover(in_space);
    }
}

TEST_CASE("Concave polygons keep their area and outline, whichever corner they begin with", "[polygon_cutter]") {
    check_cover_from_all_corners(flat({{0, 0}, {2, 0}, {1, 0.5}, {0, 2}}));                                // an arrow
    check_cover_from_all_corners(flat({{0, 0}, {9, 0}, {9, 3}, {4, 3}, {4, 6}, {0, 6}}));                  // an L
    check_cover_from_all_corners(flat({{0, 0}, {1, 0}, {1, 5}, {2, 5}, {2, 0}, {3, 0}, {3, 6}, {0, 6}}));  // a U
    check_cover_from_all_corners(
        flat({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 1}, {2, 1}, {2, 3}, {4, 3}, {4, 4}, {0, 4}, {0, 3}, {1, 3}, {1, 2}}));
}

TEST_CASE("Straight corners, points that are passed twice and holes tied to the outline are cut", "[polygon_cutter]") {
    check_cover_from_all_corners(flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}));
    check_cover_from_all_corners(flat({{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1}, {0, 1}}));
    check_cover_from_all_corners(flat(  // a square hole
        {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}));
    check_cover_from_all_corners(flat({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}));  // two parts that touch
}

Corners random_star(int count, std::mt19937& random) {
    std::uniform_real_distribution<double> radius(0.05, 1);
    Corners star;
    for (int i = 0; i < count; ++i) {
        double const angle = 2 * dataflow::portable::pi * i / count, length = radius(random);
        star.emplace_back(static_cast<float>(length * std::cos(angle)), static_cast<float>(length * std::sin(angle)),
                          0);
    }
    return star;
}

TEST_CASE("Stars of random corners keep their area", "[polygon_cutter]") {
    auto const seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 100; ++round)
        check_cover(random_star(5 + static_cast<int>(random() % 60), random));
}

TEST_CASE("Random quadrilaterals keep their area", "[polygon_cutter]") {
    auto const seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 200; ++round)
        check_cover_from_all_corners(random_star(4, random));
}

/// The outline comes back to a corner: at once, or after a spike that is infinitely thin and reaches to `tip` times as
/// far from the middle as the corner.
Corners with_corners_named_twice(Corners const& corners, std::optional<double> tip, std::mt19937& random) {
    Corners result;
    for (Eigen::Vector3d const& corner : corners) {
        result.push_back(corner);
        if (random() % 4 > 0)
            continue;
        if (tip)
            result.emplace_back(*tip * corner.x(), *tip * corner.y(), 0);
        result.push_back(corner);
    }
    return result;
}

TEST_CASE("Corners that are named twice, and spikes, cover nothing more", "[polygon_cutter]") {
    Corners const arms = flat({{0, 0}, {1, 0}, {1, 5}, {2, 5}, {2, 0}, {3, 0}, {3, 6}, {0, 6}});
    for (std::size_t doubled = 0; doubled < arms.size(); ++doubled) {
        Corners corners = arms;
        corners.insert(corners.begin() + static_cast<std::ptrdiff_t>(doubled), arms[doubled]);
        CAPTURE(doubled);
        check_cover_from_all_corners(corners);
    }
    auto const seed = std::random_device{}();
    std::optional<double> const tip = GENERATE(std::nullopt, std::optional(0.5), std::optional(2.0));
    CAPTURE(seed, tip.value_or(1));
    std::mt19937 random(seed);
    for (int round = 0; round < 100; ++round) {
        Corners const star = random_star(5 + static_cast<int>(random() % 30), random);
        check_cover_from_all_corners(with_corners_named_twice(star, tip, random));
    }
}

TEST_CASE("Spikes in any direction, along a side as well, cover nothing", "[polygon_cutter]") {
    check_cover_from_all_corners(flat({{-1, -1}, {1, -1}, {1, 1}, {1, 2}, {1, 1}, {-1, 1}}));          // straight on
    check_cover_from_all_corners(flat({{-1, -1}, {1, -1}, {1, 1}, {0, 0}, {1, 1}, {-1, 1}}));          // inwards
    check_cover_from_all_corners(flat({{-1, -1}, {1, -1}, {1.5, -1}, {1, -1}, {1, 1}, {-1, 1}}));      // on
    check_cover_from_all_corners(flat({{-1, -1}, {1, -1}, {0.5, -1}, {1, -1}, {1, 1}, {-1, 1}}));      // and back
    check_cover_from_all_corners(flat({{-1, -1}, {1, -1}, {1, 1}, {1, 3}, {1, 2}, {1, 1}, {-1, 1}}));  // in steps
    check_cover_from_all_corners(flat(
        {{-1, -1}, {1, -1}, {1, 1}, {1, 2}, {3, 2}, {1, 2}, {0, 3}, {0, 3}, {1, 2}, {1, 1}, {-1, 1}}));  // branched
    check_cover_from_all_corners(flat({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));
    check_cover_from_all_corners(flat({{0, 0}, {2, 0}, {1, 0}, {1, 1}, {0, 1}}));
}

TEST_CASE("An outline that crosses itself gets triangles all the same", "[polygon_cutter]") {
    CHECK(cut_polygon(flat({{0, 0}, {1, 1}, {1, 0}, {0, 1}})).size() == 2);
    CHECK(cut_polygon(flat({{0, 1}, {0.6, -0.8}, {-0.95, 0.3}, {0.95, 0.3}, {-0.6, -0.8}})).size() == 3);
    CHECK(cut_polygon(Corners(9, Eigen::Vector3d(1, 2, 3))).size() == 7);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(0, 1);
    for (int round = 0; round < 100; ++round) {
        Corners corners;
        for (int i = 0; i < 30; ++i)
            corners.emplace_back(place(random), place(random), place(random));
        CHECK(cut_polygon(corners).size() == 28);
    }
}

TEST_CASE("The order of cutting is a fan where a polygon is convex", "[polygon_cutter]") {
    using Triples = std::vector<CornerTriple>;
    CHECK(cut_polygon(flat({{0, 0}, {1, 0}, {0, 1}})) == Triples{{0, 1, 2}});
    CHECK(cut_polygon(flat({{0, 0}, {1, 0}, {1, 1}, {0, 1}})) == Triples{{0, 1, 2}, {0, 2, 3}});
    CHECK(cut_polygon(flat({{0, 2}, {0, 0}, {2, 0}, {0.5, 0.5}})) == Triples{{3, 0, 1}, {3, 1, 2}});
    CHECK(cut_polygon(flat({{0, 0}, {2, 0}, {3, 1}, {1, 3}, {0, 2}})) == Triples{{4, 0, 1}, {4, 1, 2}, {2, 3, 4}});
}

}  // namespace polygon_cutter_test
