#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "faster/data/mesh.hpp"

namespace faster::models {

/// How to build one class. Inside this folder lengths are millimetres; only make() turns them into metres.
struct Shape {
    std::string name;
    Eigen::Vector3d size_mm;                        ///< bounding box of the finished mesh, measured on the YCB scan
    std::function<Mesh(double edge_length)> build;  ///< right in proportion; make() fits it to `size_mm`
};

// The families, one per file.
std::vector<Shape> boxes();
std::vector<Shape> cans();
std::vector<Shape> bottles();
std::vector<Shape> kitchenware();
std::vector<Shape> tools();

}  // namespace faster::models
