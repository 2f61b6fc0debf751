#include "faster/workload/models/builtin_models.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/models/primitives/compose.hpp"
#include "faster/workload/models/shape.hpp"

namespace faster::models {
namespace {

constexpr double target_triangles = 1200.0;
constexpr double metres_per_mm = 1e-3;

std::vector<Shape> sorted_shapes() {
    std::vector<Shape> all;
    for (auto const family : {boxes, cans, bottles, kitchenware, tools}) {
        std::vector<Shape> shapes = family();
        std::move(shapes.begin(), shapes.end(), std::back_inserter(all));
    }
    std::sort(all.begin(), all.end(), [](Shape const& a, Shape const& b) { return a.name < b.name; });
    return all;
}

std::vector<Shape> const& shapes() {
    static std::vector<Shape> const all = sorted_shapes();
    return all;
}

Shape const* find(std::string const& name) {
    auto const found =
        std::find_if(shapes().begin(), shapes().end(), [&](Shape const& shape) { return shape.name == name; });
    return found == shapes().end() ? nullptr : &*found;
}

[[noreturn]] void throw_unknown(std::string const& name) {
    std::string known;
    for (std::string const& each : names()) {
        known += (known.empty() ? "" : ", ") + each;
    }
    throw InputError("no built-in model \"" + name + "\", expected one of: " + known);
}

double excess(Mesh const& mesh) { return static_cast<double>(mesh.faces.size()) - target_triangles; }

/// Bisects the edge length. The triangle count falls with it in small jumps, so the closest mesh met on the way wins.
Mesh with_target_triangles(Shape const& shape) {
    double too_short = 1.0;
    double too_long = 40.0;
    Mesh closest;
    for (int step = 0; step < 16; ++step) {
        double const edge_length = std::sqrt(too_short * too_long);
        Mesh mesh = shape.build(edge_length);
        (excess(mesh) > 0.0 ? too_short : too_long) = edge_length;
        if (std::abs(excess(mesh)) < std::abs(excess(closest))) {
            closest = std::move(mesh);
        }
    }
    return closest;
}

}  // namespace

std::vector<std::string> names() {
    std::vector<std::string> result;
    for (Shape const& shape : shapes()) {
        result.push_back(shape.name);
    }
    return result;
}

bool contains(std::string const& name) { return find(name) != nullptr; }

Mesh make(std::string const& name) {
    Shape const* const shape = find(name);
    if (shape == nullptr) {
        throw_unknown(name);
    }
    return fitted(with_target_triangles(*shape), shape->size_mm * metres_per_mm);
}

}  // namespace faster::models
