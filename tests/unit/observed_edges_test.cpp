#include "faster/workload/observed_edges.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "dataflow/base/random.hpp"
#include "faster/dataflow_names.hpp"

namespace observed_edges_test {

using namespace faster;
using namespace faster::workload;

Camera small_camera(int width, int height) { return {width, height, 100, 110, width / 2.0, height / 2.0}; }

Eigen::Vector3d point(DepthImage const& depth, Camera const& camera, int row, int column) {
    double const z = depth.at(row, column);
    return {(column - camera.cx) / camera.fx * z, (row - camera.cy) / camera.fy * z, z};
}

/// Thesis eq. 2.2, word for word; -1 for a pixel that has no value.
double curvature(DepthImage const& depth, Camera const& camera, int row, int column, int radius) {
    Eigen::Vector3d const p = point(depth, camera, row, column);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    int neighbours = 0;
    for (int r = row - radius; r <= row + radius; ++r) {
        for (int c = column - radius; c <= column + radius; ++c) {
            if ((r != row || c != column) && depth.contains(r, c) && depth.at(r, c) > 0) {
                sum += point(depth, camera, r, c) - p;
                ++neighbours;
            }
        }
    }
    return depth.at(row, column) == 0 || neighbours == 0 ? -1 : sum.norm() / (neighbours * p.norm());
}

long count(Image<std::uint8_t> const& edges) {
    return std::count(edges.pixels().begin(), edges.pixels().end(), std::uint8_t{1});
}

/// A wall 1 m away, and from column `first` on another one 1.1 m away.
DepthImage step_at(int first) {
    DepthImage depth(40, 60, 1.0);
    for (int row = 0; row < 40; ++row) {
        std::fill(depth.row(row) + first, depth.row(row) + 60, 1.1);
    }
    return depth;
}

TEST_CASE("Observed edges follow equation 2.2 at every pixel, border and gaps included", "[observed_edges]") {
    int const side = GENERATE(3, 5, 9, 51);
    Camera const camera = small_camera(37, 23);
    DepthImage depth(23, 37);
    Random random(11);
    for (double& pixel : depth.pixels()) {
        pixel = random.uniform() < 0.3 ? 0 : 0.5 + random.uniform();
    }
    ObservedEdgesConfig const config{side, 0.1};
    auto const edges = observed_edges(depth, camera, config);
    for (int row = 0; row < 23; ++row) {
        for (int column = 0; column < 37; ++column) {
            CAPTURE(side, row, column);
            double const c = curvature(depth, camera, row, column, side / 2);
            REQUIRE(std::abs(c - config.threshold) > 1e-9);  // else the comparison would be a matter of rounding
            REQUIRE(int{edges.at(row, column)} == (c > config.threshold ? 1 : 0));
        }
    }
    CHECK(count(edges) > 0);
    CHECK(count(edges) < 23 * 37);
}

TEST_CASE("A plane has no edges, upright or tilted, not even at the image border", "[observed_edges]") {
    Camera const camera;
    DepthImage depth(480, 640);
    for (int row = 0; row < 480; ++row) {
        for (int column = 0; column < 640; ++column) {
            depth.at(row, column) = 1 / (1 + 0.5 * (row - camera.cy) / camera.fy);
        }
    }
    CHECK(count(observed_edges(depth, camera, {})) == 0);
    CHECK(count(observed_edges(DepthImage(480, 640, 0.65), camera, {})) == 0);
}

TEST_CASE("A step in depth is an edge on both sides and nowhere else", "[observed_edges]") {
    auto const edges = observed_edges(step_at(30), {60, 40, 570, 570, 30, 20}, {5, 0.01});
    for (int column = 0; column < 60; ++column) {
        CAPTURE(column);
        CHECK(int{edges.at(20, column)} == (column >= 28 && column < 32 ? 1 : 0));
    }
}

TEST_CASE("A missing reading is no edge and makes none around it", "[observed_edges]") {
    DepthImage depth(40, 60, 1.0);
    for (int row = 10; row < 30; ++row) {
        std::fill(depth.row(row) + 20, depth.row(row) + 40, 0.0);
    }
    depth.at(5, 5) = 0;
    CHECK(count(observed_edges(depth, {60, 40, 570, 570, 30, 20}, {5, 0.01})) == 0);
}

TEST_CASE("A reading without any neighbour is no edge", "[observed_edges]") {
    DepthImage depth(9, 9);
    depth.at(4, 4) = 1;
    CHECK(count(observed_edges(depth, small_camera(9, 9), {5, 0.0})) == 0);
    CHECK(count(observed_edges(DepthImage(1, 1, 1.0), small_camera(1, 1), {5, 0.0})) == 0);
}

}  // namespace observed_edges_test
