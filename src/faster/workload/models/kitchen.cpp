#include <algorithm>
#include <cmath>
#include <vector>

#include "faster/workload/models/primitives/compose.hpp"
#include "faster/workload/models/primitives/skin.hpp"
#include "faster/workload/models/shape.hpp"

namespace faster::models {
namespace {

Mesh bowl(double edge_length) {
    return revolution({{0.0, 0.0},
                       {46.0, 0.0},
                       {60.0, 10.0},
                       {70.0, 25.0},
                       {75.5, 42.0},
                       {77.0, 52.0},
                       {80.5, 53.0},
                       {80.5, 55.0},
                       {75.5, 55.0},
                       {73.0, 42.0},
                       {67.5, 26.0},
                       {58.0, 12.0},
                       {45.0, 2.5},
                       {0.0, 2.5}},
                      edge_length);
}

/// A handle in the plane y = 0, on the +x side.
Mesh handle(std::vector<Station> const& stations, double edge_length) {
    return tube(stations, Eigen::Vector3d::UnitY(), edge_length);
}

/// An enamel mug: hollow, with a rolled rim. Turned so that its box is the smallest, the handle reaching into a corner.
Mesh mug(double edge_length) {
    Mesh const body = revolution({{0.0, 0.0},
                                  {38.0, 0.0},
                                  {42.0, 4.0},
                                  {43.0, 78.0},
                                  {46.5, 80.0},
                                  {45.5, 81.3},
                                  {41.0, 80.0},
                                  {39.5, 5.0},
                                  {0.0, 3.0}},
                                 edge_length);
    Mesh const ear = handle({{{41.0, 0.0, 14.0}, 4.0, 8.0, 3.0},
                             {{54.0, 0.0, 17.0}, 4.0, 8.0, 3.0},
                             {{64.0, 0.0, 28.0}, 4.0, 8.0, 3.0},
                             {{66.5, 0.0, 44.0}, 4.0, 8.0, 3.0},
                             {{64.0, 0.0, 59.0}, 4.0, 8.0, 3.0},
                             {{54.0, 0.0, 67.0}, 4.0, 8.0, 3.0},
                             {{41.0, 0.0, 68.0}, 4.0, 8.0, 3.0}},
                            edge_length);
    return turned_about_z(joined({body, ear}), 36.0);
}

/// Pulls a lip out of the upper 35 mm of a vessel, on its -x side.
Mesh with_spout(Mesh mesh, double height) {
    for (Eigen::Vector3d& vertex : mesh.vertices) {
        double const rise = std::clamp((vertex.z() - (height - 35.0)) / 35.0, 0.0, 1.0);
        double const radius = std::hypot(vertex.x(), vertex.y());
        double const facing = radius > 40.0 ? std::clamp(-vertex.x() / radius, 0.0, 1.0) : 0.0;
        vertex.x() -= 20.0 * rise * std::pow(facing, 16.0);
    }
    return mesh;
}

/// A pitcher without the lid that is on the scan: open, with spout and handle on opposite sides, near a diagonal of its
/// box.
Mesh pitcher_base(double edge_length) {
    Mesh const body = revolution({{0.0, 0.0},
                                  {50.0, 0.0},
                                  {54.0, 4.0},
                                  {62.5, 207.4},
                                  {64.0, 242.4},
                                  {61.5, 242.4},
                                  {60.0, 207.4},
                                  {51.5, 5.0},
                                  {0.0, 3.0}},
                                 edge_length);
    Mesh const ear = handle({{{54.0, 0.0, 92.0}, 4.0, 10.0, 3.0},
                             {{70.0, 0.0, 90.0}, 4.5, 10.0, 3.0},
                             {{87.0, 0.0, 98.0}, 5.0, 10.0, 3.0},
                             {{97.0, 0.0, 122.0}, 5.0, 10.0, 3.0},
                             {{102.0, 0.0, 165.0}, 5.0, 10.0, 3.0},
                             {{104.0, 0.0, 205.0}, 5.0, 10.0, 3.0},
                             {{96.0, 0.0, 224.0}, 5.0, 10.0, 3.0},
                             {{79.0, 0.0, 229.0}, 4.5, 10.0, 3.0},
                             {{62.5, 0.0, 229.0}, 4.0, 10.0, 3.0}},
                            edge_length);
    return turned_about_z(joined({with_spout(body, 242.4), ear}), 43.0);
}

/// A bent tapered tube lying flat, its stem at +y.
Mesh banana(double edge_length) {
    return tube({{{17.0, -98.0, 0.0}, 3.5, 3.5},
                 {{14.0, -90.0, 0.0}, 8.0, 8.0},
                 {{6.0, -74.0, 0.0}, 13.0, 13.0},
                 {{-6.0, -48.0, 0.0}, 17.0, 17.0},
                 {{-14.0, -16.0, 0.0}, 18.5, 18.3},
                 {{-15.0, 16.0, 0.0}, 18.5, 18.3},
                 {{-8.0, 44.0, 0.0}, 16.5, 16.5},
                 {{5.0, 65.0, -3.0}, 12.0, 12.0},
                 {{16.0, 78.0, -6.0}, 6.5, 6.5},
                 {{24.0, 87.0, -8.0}, 4.8, 4.8},
                 {{31.0, 96.5, -9.0}, 5.5, 5.5}},
                Eigen::Vector3d::UnitZ(), edge_length);
}

}  // namespace

std::vector<Shape> kitchenware() {
    return {
        {"banana", {69.0, 197.6, 36.7}, banana},
        {"bowl", {160.4, 161.0, 55.0}, bowl},
        {"mug", {105.3, 93.0, 81.3}, mug},
        {"pitcher_base", {149.7, 144.0, 242.4}, pitcher_base},
    };
}

}  // namespace faster::models
