#include "faster/workload/models/builtin_models.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"

namespace builtin_models_test {

using faster::Mesh;
namespace models = faster::models;

struct ClassSize {
    std::string name;
    Eigen::Vector3d size_mm;
};

/// Smallest box of each YCB scan after turning it about z, as measured on the scans; x and y in the order of the
/// longer and shorter side of the unturned scan.
std::vector<ClassSize> const scanned_sizes{
    {"banana", {69.0, 197.6, 36.7}},
    {"bleach_cleanser", {102.4, 67.7, 250.6}},
    {"bowl", {160.4, 161.0, 55.0}},
    {"cracker_box", {71.8, 163.9, 213.4}},
    {"extra_large_clamp", {202.3, 165.2, 36.3}},
    {"foam_brick", {52.0, 77.6, 51.2}},
    {"gelatin_box", {72.9, 89.3, 30.1}},
    {"large_clamp", {121.2, 165.4, 39.2}},
    {"large_marker", {19.0, 120.9, 18.9}},
    {"master_chef_can", {102.2, 102.3, 140.2}},
    {"mug", {105.3, 93.0, 81.3}},
    {"mustard_bottle", {95.9, 58.2, 191.3}},
    {"pitcher_base", {149.7, 144.0, 242.4}},
    {"potted_meat_can", {101.6, 57.3, 83.5}},
    {"power_drill", {184.2, 187.0, 57.3}},
    {"pudding_box", {89.8, 112.7, 38.9}},
    {"scissors", {88.1, 197.7, 15.7}},
    {"sugar_box", {47.9, 93.3, 176.0}},
    {"tomato_soup_can", {67.4, 67.6, 101.9}},
    {"tuna_fish_can", {85.3, 85.3, 33.5}},
    {"wood_block", {89.9, 90.6, 206.0}},
};

Eigen::AlignedBox3d bounds_of(Mesh const& mesh) {
    Eigen::AlignedBox3d bounds;
    for (Eigen::Vector3d const& vertex : mesh.vertices) {
        bounds.extend(vertex);
    }
    return bounds;
}

Eigen::Vector3d twice_area(Mesh const& mesh, std::array<std::uint32_t, 3> const& face) {
    Eigen::Vector3d const& a = mesh.vertices[face[0]];
    return (mesh.vertices[face[1]] - a).cross(mesh.vertices[face[2]] - a);
}

/// How often each directed edge is walked by a face.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> directed_edges(Mesh const& mesh) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (auto const& face : mesh.faces) {
        for (std::size_t i = 0; i < 3; ++i) {
            ++edges[{face[i], face[(i + 1) % 3]}];
        }
    }
    return edges;
}

/// Every edge belongs to exactly two faces, which walk it in opposite directions.
bool is_closed_and_oriented(Mesh const& mesh) {
    auto const edges = directed_edges(mesh);
    return std::all_of(edges.begin(), edges.end(), [&](auto const& entry) {
        auto const& [edge, uses] = entry;
        return uses == 1 && edge.first != edge.second && edges.count({edge.second, edge.first}) == 1;
    });
}

/// For each vertex, the smallest vertex it is connected to.
std::vector<std::uint32_t> component_of_vertices(Mesh const& mesh) {
    std::vector<std::uint32_t> component(mesh.vertices.size());
    for (std::uint32_t i = 0; i < component.size(); ++i) {
        component[i] = i;
    }
    for (bool changed = true; changed;) {
        changed = false;
        for (auto const& face : mesh.faces) {
            std::uint32_t const least = std::min({component[face[0]], component[face[1]], component[face[2]]});
            for (std::uint32_t const vertex : face) {
                changed = changed || component[vertex] != least;
                component[vertex] = least;
            }
        }
    }
    return component;
}

/// Volume of each component [m3], positive if it faces outwards.
std::map<std::uint32_t, double> component_volumes(Mesh const& mesh) {
    std::vector<std::uint32_t> const component = component_of_vertices(mesh);
    std::map<std::uint32_t, double> volumes;
    for (auto const& face : mesh.faces) {
        double const six_volumes = mesh.vertices[face[0]].dot(mesh.vertices[face[1]].cross(mesh.vertices[face[2]]));
        volumes[component[face[0]]] += six_volumes / 6.0;
    }
    return volumes;
}

double volume_litres(std::string const& name) {
    double litres = 0.0;
    for (auto const& [component, volume] : component_volumes(models::make(name))) {
        litres += 1000.0 * volume;
    }
    return litres;
}

TEST_CASE("The built-in models are the 21 YCB classes, sorted by name", "[models]") {
    std::vector<std::string> expected;
    expected.reserve(scanned_sizes.size());
    for (ClassSize const& each : scanned_sizes) {
        expected.push_back(each.name);
    }
    CHECK(models::names() == expected);
    CHECK(std::is_sorted(expected.begin(), expected.end()));
}

TEST_CASE("A name is known exactly if it is listed", "[models]") {
    for (std::string const& name : models::names()) {
        CHECK(models::contains(name));
    }
    CHECK_FALSE(models::contains("003_cracker_box"));
    CHECK_FALSE(models::contains("Banana"));
    CHECK_FALSE(models::contains(""));
}

TEST_CASE("An unknown name is an input error that lists the known ones", "[models]") {
    CHECK_THROWS_AS(models::make("teapot"), faster::InputError);
    CHECK_THROWS_WITH(models::make("teapot"),
                      Catch::Contains("\"teapot\"") && Catch::Contains("banana, bleach_cleanser, bowl"));
}

TEST_CASE("Every model has about 1,200 triangles", "[models]") {
    for (std::string const& name : models::names()) {
        INFO(name);
        std::size_t const triangles = models::make(name).faces.size();
        CHECK(triangles >= 1000);
        CHECK(triangles <= 1400);
    }
}

TEST_CASE("Every model is as large as the scanned object, within 2 %", "[models]") {
    for (ClassSize const& each : scanned_sizes) {
        INFO(each.name);
        Eigen::Vector3d const size_mm = 1000.0 * bounds_of(models::make(each.name)).sizes();
        for (int axis = 0; axis < 3; ++axis) {
            INFO("axis " << axis);
            CHECK(size_mm(axis) == Approx(each.size_mm(axis)).epsilon(0.02));
        }
    }
}

TEST_CASE("The origin of every model is the centre of its bounding box", "[models]") {
    for (std::string const& name : models::names()) {
        INFO(name);
        CHECK(bounds_of(models::make(name)).center().norm() < 1e-12);
    }
}

TEST_CASE("Every vertex is finite and used, and every face refers to vertices that exist", "[models]") {
    for (std::string const& name : models::names()) {
        INFO(name);
        Mesh const mesh = models::make(name);
        std::vector<bool> used(mesh.vertices.size(), false);
        for (auto const& face : mesh.faces) {
            for (std::uint32_t const vertex : face) {
                REQUIRE(vertex < mesh.vertices.size());
                used[vertex] = true;
            }
        }
        CHECK(std::all_of(used.begin(), used.end(), [](bool each) { return each; }));
        CHECK(std::all_of(mesh.vertices.begin(), mesh.vertices.end(),
                          [](Eigen::Vector3d const& vertex) { return vertex.allFinite(); }));
    }
}

TEST_CASE("Every edge is shared by exactly two faces with opposite directions", "[models]") {
    for (std::string const& name : models::names()) {
        INFO(name);
        CHECK(is_closed_and_oriented(models::make(name)));
    }
}

TEST_CASE("Every component faces outwards", "[models]") {
    for (std::string const& name : models::names()) {
        INFO(name);
        for (auto const& [component, volume] : component_volumes(models::make(name))) {
            INFO("component of vertex " << component);
            CHECK(volume > 0.0);
        }
    }
}

TEST_CASE("No triangle is degenerate", "[models]") {
    for (std::string const& name : models::names()) {
        INFO(name);
        Mesh const mesh = models::make(name);
        for (auto const& face : mesh.faces) {
            CHECK(twice_area(mesh, face).norm() / 2.0 > 1e-9);
        }
    }
}

TEST_CASE("Triangles are roughly even: none holds more than one per cent of the surface", "[models]") {
    for (std::string const& name : models::names()) {
        INFO(name);
        Mesh const mesh = models::make(name);
        double total = 0.0;
        double largest = 0.0;
        for (auto const& face : mesh.faces) {
            double const area = twice_area(mesh, face).norm() / 2.0;
            total += area;
            largest = std::max(largest, area);
        }
        CHECK(largest < 0.01 * total);
    }
}

TEST_CASE("Boxes and cans are solid, bowl, mug and pitcher are hollow", "[models]") {
    CHECK(volume_litres("cracker_box") == Approx(0.718 * 1.639 * 2.134).epsilon(1e-9));
    CHECK(volume_litres("tuna_fish_can") == Approx(3.1416 / 4.0 * 0.853 * 0.853 * 0.335).epsilon(0.1));
    CHECK(volume_litres("bowl") < 0.15);
    CHECK(volume_litres("mug") < 0.15);
    CHECK(volume_litres("pitcher_base") < 0.4);
}

TEST_CASE("A model comes out the same at every call", "[models]") {
    Mesh const first = models::make("power_drill");
    Mesh const second = models::make("power_drill");
    CHECK(first.vertices == second.vertices);
    CHECK(first.faces == second.faces);
}

}  // namespace builtin_models_test
