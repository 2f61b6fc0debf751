#include "workload/models/primitives/box.hpp"
#include "workload/models/shape.hpp"

namespace faster::models {
namespace {

Shape plain_box(std::string const& name, double x, double y, double z) {
    Eigen::Vector3d const size(x, y, z);
    return {name, size, [size](double edge_length) { return box(size, edge_length); }};
}

}  // namespace

std::vector<Shape> boxes() {
    return {
        plain_box("cracker_box", 71.8, 163.9, 213.4), plain_box("foam_brick", 52.0, 77.6, 51.2),
        plain_box("gelatin_box", 72.9, 89.3, 30.1),   plain_box("pudding_box", 89.8, 112.7, 38.9),
        plain_box("sugar_box", 47.9, 93.3, 176.0),    plain_box("wood_block", 89.9, 90.6, 206.0),
    };
}

}  // namespace faster::models
