#include "workload/models/primitives/loft.hpp"
#include "workload/models/primitives/revolution.hpp"
#include "workload/models/shape.hpp"

namespace faster::models {
namespace {

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

std::vector<Shape> cans() {
    return {
        round_can("master_chef_can", 102.2, 102.3, 140.2),
        round_can("tomato_soup_can", 67.4, 67.6, 101.9),
        round_can("tuna_fish_can", 85.3, 85.3, 33.5),
        {"potted_meat_can", {101.6, 57.3, 83.5}, potted_meat_can},
    };
}

}  // namespace faster::models
