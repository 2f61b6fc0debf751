#include <vector>

#include "faster/workload/models/primitives/compose.hpp"
#include "faster/workload/models/primitives/skin.hpp"
#include "faster/workload/models/shape.hpp"

/// Tools lie flat: their outlines are drawn in x and y, z is their thickness.
namespace faster::models {
namespace {

/// A part with a curved way in the plane of the tool.
Mesh curved(std::vector<Station> const& stations, double edge_length, Ends ends = Ends::capped) {
    return tube(stations, Eigen::Vector3d::UnitZ(), edge_length, Between::smooth, ends);
}

/// A part with sharp steps; its way is a line in the plane of the tool.
Mesh stepped(std::vector<Station> const& stations, double edge_length) {
    return tube(stations, Eigen::Vector3d::UnitZ(), edge_length, Between::straight);
}

/// An upright round pin through the tool.
Mesh pin(double x, double y, double radius, double half_height, double edge_length) {
    return tube({{{x, y, -half_height}, radius, radius}, {{x, y, half_height}, radius, radius}},
                Eigen::Vector3d::UnitX(), edge_length, Between::straight);
}

/// Chuck towards -x, battery towards -y.
Mesh power_drill(double edge_length) {
    Mesh const head = stepped({{{-92.0, 67.0, 0.0}, 7.0, 7.0},
                               {{-84.0, 67.0, 0.0}, 12.0, 12.0},
                               {{-78.0, 67.0, 0.0}, 18.0, 18.0},
                               {{-58.0, 67.0, 0.0}, 20.0, 20.0},
                               {{-56.0, 67.0, 0.0}, 17.5, 17.5},
                               {{-40.0, 67.0, 0.0}, 19.0, 19.0},
                               {{-38.0, 67.0, 0.0}, 22.0, 23.0},
                               {{-10.0, 67.0, 0.0}, 24.5, 27.0, 2.5},
                               {{70.0, 67.0, 0.0}, 25.0, 28.0, 2.5},
                               {{84.0, 67.0, 0.0}, 22.0, 25.0, 2.5},
                               {{92.0, 67.0, 0.0}, 14.0, 16.0}},
                              edge_length);
    Mesh const grip = curved({{{36.0, 58.0, 0.0}, 22.0, 15.0, 2.5},
                              {{36.0, 30.0, 0.0}, 19.0, 15.0, 2.5},
                              {{39.0, 5.0, 0.0}, 18.0, 16.0, 2.5},
                              {{42.0, -20.0, 0.0}, 17.5, 15.0, 2.5},
                              {{42.0, -45.0, 0.0}, 20.0, 17.0, 3.0},
                              {{38.0, -68.0, 0.0}, 27.0, 22.0, 3.0}},
                             edge_length);
    Mesh const battery = stepped({{{18.0, -93.0, 0.0}, 48.0, 26.0, 6.0},
                                  {{18.0, -90.0, 0.0}, 50.5, 28.0, 6.0},
                                  {{18.0, -68.0, 0.0}, 50.5, 28.0, 6.0},
                                  {{18.0, -60.0, 0.0}, 46.0, 25.0, 6.0}},
                                 edge_length);
    Mesh const trigger = curved({{{6.0, 46.0, 0.0}, 6.0, 7.0},
                                 {{6.0, 34.0, 0.0}, 6.0, 7.0},
                                 {{11.0, 24.0, 0.0}, 6.0, 7.0},
                                 {{24.0, 14.0, 0.0}, 7.0, 7.0}},
                                edge_length);
    return joined({head, grip, battery, trigger});
}

/// Blades nearly closed, their points towards +y; a round and a long finger ring.
Mesh scissors(double edge_length) {
    Mesh const left_blade = stepped({{{-2.0, 2.0, 1.5}, 4.0, 1.5},
                                     {{0.0, 20.0, 1.5}, 8.5, 1.5},
                                     {{3.0, 60.0, 1.5}, 6.0, 1.4},
                                     {{6.0, 98.8, 1.5}, 2.0, 1.0}},
                                    edge_length);
    Mesh const right_blade = stepped({{{3.0, 2.0, -1.5}, 4.0, 1.5},
                                      {{2.0, 20.0, -1.5}, 8.5, 1.5},
                                      {{5.0, 60.0, -1.5}, 6.0, 1.4},
                                      {{7.0, 96.0, -1.5}, 2.0, 1.0}},
                                     edge_length);
    Mesh const round_ring = curved({{{-11.0, -40.0, 0.0}, 5.0, 7.0},
                                    {{-23.0, -32.0, 0.0}, 4.5, 7.8},
                                    {{-36.0, -43.0, 0.0}, 4.5, 7.8},
                                    {{-39.0, -62.0, 0.0}, 4.5, 7.8},
                                    {{-31.0, -79.0, 0.0}, 4.5, 7.8},
                                    {{-18.0, -80.0, 0.0}, 4.5, 7.8},
                                    {{-9.0, -64.0, 0.0}, 4.5, 7.8}},
                                   edge_length, Ends::joined);
    Mesh const long_ring = curved({{{9.0, -36.0, 0.0}, 5.0, 7.0},
                                   {{4.0, -58.0, 0.0}, 4.5, 7.8},
                                   {{8.0, -82.0, 0.0}, 4.5, 7.8},
                                   {{19.0, -94.0, 0.0}, 4.5, 7.8},
                                   {{33.0, -87.0, 0.0}, 4.5, 7.8},
                                   {{39.0, -66.0, 0.0}, 4.5, 7.8},
                                   {{34.0, -42.0, 0.0}, 4.5, 7.8},
                                   {{21.0, -26.0, 0.0}, 5.0, 7.0}},
                                  edge_length, Ends::joined);
    Mesh const left_shank = curved({{{-19.0, -36.0, 0.0}, 8.0, 6.0},
                                    {{-7.0, -14.0, 0.0}, 8.0, 5.0},
                                    {{-1.0, 6.0, 0.0}, 7.0, 4.0},
                                    {{1.0, 18.0, 0.0}, 7.0, 3.5}},
                                   edge_length);
    Mesh const right_shank = curved({{{17.0, -31.0, 0.0}, 9.0, 6.0},
                                     {{9.0, -12.0, 0.0}, 8.0, 5.0},
                                     {{3.0, 6.0, 0.0}, 7.0, 4.0},
                                     {{1.0, 18.0, 0.0}, 7.0, 3.5}},
                                    edge_length);
    return joined({left_blade, right_blade, round_ring, long_ring, left_shank, right_shank,
                   pin(1.0, 14.0, 5.0, 5.0, edge_length)});
}

/// Writing end towards +y.
Mesh large_marker(double edge_length) {
    return stepped({{{0.0, 0.0, 0.0}, 8.0, 8.0},
                    {{0.0, 1.5, 0.0}, 9.2, 9.2},
                    {{0.0, 90.0, 0.0}, 9.0, 9.0},
                    {{0.0, 93.0, 0.0}, 7.8, 7.8},
                    {{0.0, 100.0, 0.0}, 8.0, 8.0},
                    {{0.0, 115.0, 0.0}, 9.5, 9.5},
                    {{0.0, 115.5, 0.0}, 4.5, 4.5},
                    {{0.0, 120.9, 0.0}, 4.0, 4.0}},
                   edge_length);
}

/// Stations as they are on the other side of the y axis.
std::vector<Station> mirrored(std::vector<Station> stations) {
    for (Station& station : stations) {
        station.centre.x() = -station.centre.x();
    }
    return stations;
}

/// A spring clamp, held by a pin at the origin. `half` is its -x side, from the handle (+y) to the closed jaw (-y); the
/// other side mirrors it.
Mesh clamp(std::vector<Station> const& half, double pin_radius, double pin_half_height, double edge_length) {
    return joined({curved(half, edge_length), curved(mirrored(half), edge_length),
                   pin(0.0, 0.0, pin_radius, pin_half_height, edge_length)});
}

/// Handles towards +y.
Mesh large_clamp(double edge_length) {
    return clamp({{{-56.0, 84.0, 0.0}, 5.0, 8.0},
                  {{-52.0, 77.0, 0.0}, 8.5, 12.0, 3.0},
                  {{-38.0, 55.0, 0.0}, 9.0, 13.0, 3.0},
                  {{-22.0, 26.0, 0.0}, 9.0, 13.0, 3.0},
                  {{-13.0, 5.0, 0.0}, 9.0, 14.0, 4.0},
                  {{-25.0, -20.0, 0.0}, 11.0, 14.0, 4.0},
                  {{-25.0, -42.0, 0.0}, 9.5, 14.0, 4.0},
                  {{-13.0, -64.0, 0.0}, 7.0, 14.0, 4.0},
                  {{-4.0, -78.0, 0.0}, 5.0, 14.0, 4.0}},
                 12.0, 19.6, edge_length);
}

/// Handles towards +x.
Mesh extra_large_clamp(double edge_length) {
    return turned_about_z(clamp({{{-78.0, 101.0, 0.0}, 5.0, 8.0},
                                 {{-72.0, 94.0, 0.0}, 9.5, 12.0, 3.0},
                                 {{-53.0, 70.0, 0.0}, 10.0, 13.0, 3.0},
                                 {{-30.0, 42.0, 0.0}, 10.0, 13.0, 3.0},
                                 {{-15.0, 12.0, 0.0}, 10.0, 14.0, 4.0},
                                 {{-30.0, -18.0, 0.0}, 12.0, 14.0, 4.0},
                                 {{-33.0, -46.0, 0.0}, 11.0, 14.0, 4.0},
                                 {{-18.0, -74.0, 0.0}, 8.0, 14.0, 4.0},
                                 {{-4.0, -96.0, 0.0}, 5.0, 14.0, 4.0}},
                                13.0, 18.1, edge_length),
                          -90.0);
}

}  // namespace

std::vector<Shape> tools() {
    return {
        {"power_drill", {184.2, 187.0, 57.3}, power_drill},
        {"scissors", {88.1, 197.7, 15.7}, scissors},
        {"large_marker", {19.0, 120.9, 18.9}, large_marker},
        {"large_clamp", {121.2, 165.4, 39.2}, large_clamp},
        {"extra_large_clamp", {202.3, 165.2, 36.3}, extra_large_clamp},
    };
}

}  // namespace faster::models
