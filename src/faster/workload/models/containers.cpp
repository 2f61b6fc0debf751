#include "faster/workload/models/primitives/box.hpp"
#include "faster/workload/models/primitives/skin.hpp"
#include "faster/workload/models/shape.hpp"

namespace faster::models {

namespace {

/// A waisted flat bottle with a round collar and a conical nozzle.
Mesh mustard_bottle(double edge_length) {
    return loft({{0.0, 45.0, 26.0, 4.0},
                 {4.0, 47.5, 28.5, 4.0},
                 {32.0, 48.0, 29.1, 3.5},
                 {56.0, 43.0, 28.5, 3.0},
                 {72.0, 38.0, 28.0, 3.0},
                 {90.0, 37.0, 27.5, 3.0},
                 {106.0, 42.0, 28.0, 3.0},
                 {124.0, 47.0, 28.5, 2.8},
                 {138.0, 45.0, 27.5, 2.5},
                 {150.0, 34.0, 23.0, 2.2},
                 {157.0, 20.0, 17.0},
                 {158.0, 20.0, 20.0},
                 {169.0, 19.5, 19.5},
                 {171.0, 11.0, 11.0},
                 {191.3, 6.5, 6.5}},
                edge_length);
}

/// A bottle that leans to its straight back (+x), with a waist to grip below the shoulder and a round cap.
Mesh bleach_cleanser(double edge_length) {
    return loft({{0.0, 49.0, 32.0, 4.0},
                 {4.0, 51.2, 33.8, 4.0},
                 {14.0, 51.2, 33.8, 4.0},
                 {18.0, 48.0, 33.0, 4.0, 3.0},
                 {80.0, 44.5, 29.5, 3.5, 6.0},
                 {140.0, 40.5, 26.0, 3.2, 9.5},
                 {175.0, 34.0, 21.0, 2.8, 16.0},
                 {187.0, 31.0, 20.0, 2.5, 17.0},
                 {194.0, 35.0, 25.0, 2.3, 14.0},
                 {212.0, 37.0, 25.0, 2.2, 12.0},
                 {226.0, 29.0, 20.0, 2.0, 14.0},
                 {232.0, 15.0, 15.0, 2.0, 10.0},
                 {250.6, 15.0, 15.0, 2.0, 10.0}},
                edge_length);
}

Shape plain_box(std::string const& name, double x, double y, double z) {
    Eigen::Vector3d const size(x, y, z);
    return {name, size, [size](double edge_length) { return box(size, edge_length); }};
}

/// A round can: rims 1 mm wider than the wall at both ends, and a lid sunk 2 mm below the upper rim.
Shape round_can(std::string const& name, double diameter_x, double diameter_y, double height) {
    double const rim = (diameter_x + diameter_y) / 4.0;
    std::vector<ProfilePoint> const profile{
        {0.0, 0.0},    {rim, 0.0},          {rim - 1.0, 3.0},          {rim - 1.0, height - 3.0},
        {rim, height}, {rim - 2.0, height}, {rim - 3.5, height - 2.0}, {0.0, height - 2.0}};
    return {name, {diameter_x, diameter_y, height}, [profile](double edge_length) {
                return revolution(profile, edge_length);
            }};
}

/// A rounded box with a rim around the lid.
Mesh potted_meat_can(double edge_length) {
    return loft({{0.0, 48.0, 26.0, 5.0},
                 {3.0, 49.0, 27.0, 5.0},
                 {78.0, 49.0, 27.0, 5.0},
                 {80.5, 50.8, 28.7, 5.0},
                 {83.5, 50.8, 28.7, 5.0},
                 {83.5, 48.8, 26.7, 5.0},
                 {81.5, 47.8, 25.7, 5.0}},
                edge_length);
}

}  // namespace

std::vector<Shape> bottles() {
    return {
        {"bleach_cleanser", {102.4, 67.7, 250.6}, bleach_cleanser},
        {"mustard_bottle", {95.9, 58.2, 191.3}, mustard_bottle},
    };
}

std::vector<Shape> boxes() {
    return {
        plain_box("cracker_box", 71.8, 163.9, 213.4), plain_box("foam_brick", 52.0, 77.6, 51.2),
        plain_box("gelatin_box", 72.9, 89.3, 30.1),   plain_box("pudding_box", 89.8, 112.7, 38.9),
        plain_box("sugar_box", 47.9, 93.3, 176.0),    plain_box("wood_block", 89.9, 90.6, 206.0),
    };
}

std::vector<Shape> cans() {
    return {
        round_can("master_chef_can", 102.2, 102.3, 140.2),
        round_can("tomato_soup_can", 67.4, 67.6, 101.9),
        round_can("tuna_fish_can", 85.3, 85.3, 33.5),
        {"potted_meat_can", {101.6, 57.3, 83.5}, potted_meat_can},
    };
}

}  // namespace faster::models
