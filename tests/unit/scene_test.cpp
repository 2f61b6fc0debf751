#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "faster/workload/build_stimulus.hpp"
#include "faster/workload/files/mesh_file.hpp"
#include "faster/workload/files/png_image.hpp"
#include "faster/workload/object_mesh.hpp"
#include "faster/workload/object_pose.hpp"
#include "faster/workload/observed_edges.hpp"
#include "faster/workload/scene_renderer.hpp"
#include "faster/workload/sensor_noise.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace scene_test {

using namespace faster;
using namespace faster::workload;
using test::input_error_text;
using test::TempFolder;

Camera const small_camera{64, 48, 60, 60, 31.5, 23.5};

long readings(DepthImage const& depth) {
    return std::count_if(depth.pixels().begin(), depth.pixels().end(), [](double pixel) { return pixel > 0; });
}

/// A square of the given half side in the plane z = 0, cut into two triangles.
Mesh square(double half) {
    return {{{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}}, {{0, 1, 2}, {0, 2, 3}}};
}

Pose at(double x, double y, double z) {
    Pose pose;
    pose.translation = Eigen::Vector3d(x, y, z);
    return pose;
}

/// A sphere of latitude-longitude strips, counter-clockwise seen from outside.
Mesh sphere(double radius, unsigned rings) {
    Mesh mesh;
    unsigned const sectors = 2 * rings;
    double const step = portable::pi / rings;
    for (unsigned ring = 0; ring <= rings; ++ring) {
        for (unsigned sector = 0; sector < sectors; ++sector) {
            double const polar = ring * step, azimuth = sector * step;
            mesh.vertices.emplace_back(radius * Eigen::Vector3d(std::sin(polar) * std::cos(azimuth),
                                                                std::sin(polar) * std::sin(azimuth), std::cos(polar)));
        }
    }
    for (unsigned ring = 0; ring < rings; ++ring) {
        for (unsigned sector = 0; sector < sectors; ++sector) {
            unsigned const next = (sector + 1) % sectors;
            unsigned const above = ring * sectors, below = above + sectors;
            mesh.faces.push_back({above + sector, below + sector, below + next});
            mesh.faces.push_back({above + sector, below + next, above + next});
        }
    }
    return mesh;
}

double volume(Mesh const& mesh) {
    double sum = 0;
    for (auto const& face : mesh.faces) {
        sum += mesh.vertices[face[0]].dot(mesh.vertices[face[1]].cross(mesh.vertices[face[2]])) / 6;
    }
    return sum;
}

WorkloadConfig small_workload() {
    WorkloadConfig config;
    config.camera = small_camera;
    config.samples.count = 5;
    return config;
}

std::string build_error(WorkloadConfig const& config) {
    return input_error_text([&] { build_stimulus(config, 40, {}); });
}

TEST_CASE("A square facing the camera covers the pixels its outline says, at its depth", "[scene_renderer]") {
    DepthImage depth(48, 64);
    draw_mesh(square(0.1), at(0, 0, 0.5), small_camera, depth);  // +-12 pixels around (23.5, 31.5)
    for (int row = 0; row < 48; ++row) {
        for (int column = 0; column < 64; ++column) {
            CAPTURE(row, column);
            bool const covered = row >= 12 && row <= 35 && column >= 20 && column <= 43;
            REQUIRE(depth.at(row, column) == Approx(covered ? 0.5 : 0.0));
        }
    }
}

TEST_CASE("The nearest surface wins, whatever the order of drawing", "[scene_renderer]") {
    DepthImage front_first(48, 64), back_first(48, 64);
    draw_mesh(square(0.05), at(0, 0, 0.5), small_camera, front_first);
    draw_mesh(square(0.2), at(0, 0, 0.8), small_camera, front_first);
    draw_mesh(square(0.2), at(0, 0, 0.8), small_camera, back_first);
    draw_mesh(square(0.05), at(0, 0, 0.5), small_camera, back_first);
    CHECK(front_first == back_first);
    CHECK(front_first.at(24, 32) == Approx(0.5));
    CHECK(front_first.at(12, 20) == Approx(0.8));
}

TEST_CASE("A tilted plane has the depth its equation says", "[scene_renderer]") {
    DepthImage depth(48, 64);
    Plane const plane{{0, 0.1, 0.6}, {0, -std::cos(0.5), -std::sin(0.5)}};
    draw_plane(plane, small_camera, depth);
    CHECK(readings(depth) > 1000);
    for (int row = 0; row < 48; ++row) {
        double const z = depth.at(row, 10);
        if (z > 0) {
            Eigen::Vector3d const point((10 - 31.5) / 60 * z, (row - 23.5) / 60 * z, z);
            CHECK(plane.normal.dot(point - plane.point) == Approx(0).margin(1e-12));
        }
    }
}

TEST_CASE("A surface that reaches behind the camera is drawn where it is in front", "[scene_renderer]") {
    Mesh const floor{{{-50, 0.3, -50}, {50, 0.3, -50}, {0, 0.3, 100}}, {{0, 1, 2}}};
    DepthImage drawn(48, 64), expected(48, 64);
    draw_mesh(floor, at(0, 0, 0), small_camera, drawn);
    draw_plane({{0, 0.3, 0}, {0, 1, 0}}, small_camera, expected);
    CHECK(readings(drawn) == 24 * 64);  // the rows below the horizon
    for (int row = 24; row < 48; ++row) {
        CHECK(drawn.at(row, 32) == Approx(expected.at(row, 32)));
    }
}

TEST_CASE("A mesh without cracks is drawn without holes, and as a sphere should look", "[scene_renderer]") {
    DepthImage depth(48, 64);
    draw_mesh(sphere(0.1, 40), at(0.01, -0.02, 0.5), small_camera, depth);
    for (int row = 0; row < 48; ++row) {
        for (int column = 0; column < 64; ++column) {
            Eigen::Vector3d const ray((column - 31.5) / 60, (row - 23.5) / 60, 1), centre(0.01, -0.02, 0.5);
            double const along = ray.dot(centre) / ray.squaredNorm();
            double const gap = (along * ray - centre).norm();
            if (gap < 0.099) {
                double const expected = along - std::sqrt(0.01 - gap * gap) / ray.norm();
                REQUIRE(depth.at(row, column) == Approx(expected).margin(0.002));
            }
        }
    }
}

TEST_CASE("Sensor noise is repeatable and only where it is wanted", "[sensor_noise]") {
    NoiseConfig config;
    DepthImage const perfect(48, 64, 0.8);
    DepthImage once = perfect, again = perfect, other = perfect, quiet = perfect;
    add_sensor_noise(once, config, 1);
    add_sensor_noise(again, config, 1);
    add_sensor_noise(other, config, 2);
    config.enabled = false;
    add_sensor_noise(quiet, config, 1);
    CHECK(once == again);
    CHECK_FALSE(once == other);
    CHECK(quiet == perfect);
}

TEST_CASE("Axial noise grows with distance as configured", "[sensor_noise]") {
    NoiseConfig config;
    config.random_dropout = 0;
    for (double const z : {0.4, 0.8, 2.0}) {
        DepthImage depth(480, 640, z);
        add_sensor_noise(depth, config, 7);
        double squares = 0;
        for (double const pixel : depth.pixels()) {
            squares += (pixel - z) * (pixel - z);
        }
        double const expected = 0.0012 + 0.0019 * (z - 0.4) * (z - 0.4);
        CHECK(std::sqrt(squares / (480 * 640)) == Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("Readings are lost at depth edges and at random, as often as configured", "[sensor_noise]") {
    NoiseConfig config;
    config.random_dropout = 0.1;
    config.edge_dropout = 0.5;
    DepthImage depth(480, 640, 1.0);
    for (int row = 0; row < 480; ++row) {
        std::fill(depth.row(row) + 320, depth.row(row) + 640, 1.1);
    }
    add_sensor_noise(depth, config, 7);
    long lost_at_edge = 0;
    for (int row = 0; row < 480; ++row) {
        lost_at_edge += (depth.at(row, 319) == 0 ? 1 : 0) + (depth.at(row, 320) == 0 ? 1 : 0);
    }
    CHECK(static_cast<double>(lost_at_edge) / 960 == Approx(0.55).margin(0.06));  // 1 - 0.5 * 0.9
    CHECK(static_cast<double>(480 * 640 - readings(depth) - lost_at_edge) / (480 * 638) == Approx(0.1).margin(0.005));
}

TEST_CASE("Depth codes are truncated, end at far, and keep missing readings", "[depth_image]") {
    DepthImage depth(1, 8);
    depth.pixels() = {0, 0.001, 1.0 / 512, 0.65, 3.998, 3.99805, 4.0, 1e9};
    CHECK(depth_codes(depth, 9).pixels() ==
          std::vector<std::uint16_t>{0, 0, 1, 332, 2046, 2047, far_depth_code, far_depth_code});
    CHECK(depth_codes(depth, 0).pixels()[4] == 3);
    CHECK(depth_codes(depth, 11).pixels()[3] == 1331);
}

TEST_CASE("A depth image is scaled to metres and thinned out from pixel 0 on", "[depth_image]") {
    TempFolder const folder;
    Image<std::uint16_t> raw(5, 7);
    for (int row = 0; row < 5; ++row) {
        for (int column = 0; column < 7; ++column) {
            raw.at(row, column) = static_cast<std::uint16_t>(1000 * row + column);
        }
    }
    files::write_png(folder / "d.png", raw);
    DepthImage const depth = load_depth_image(folder / "d.png", 0.001, {7, 5, 60, 50, 3, 2}, 3);
    REQUIRE(depth.height() == 2);
    REQUIRE(depth.width() == 3);
    CHECK(depth.at(1, 2) == Approx(3.006));
    Camera const camera = downscaled({7, 5, 60, 50, 3, 2}, 3);
    CHECK(camera.width == 3);
    CHECK(camera.height == 2);
    CHECK(camera.fx == Approx(20));
    CHECK(camera.cy == Approx(2.0 / 3));
    CHECK_THAT(input_error_text([&] { load_depth_image(folder / "d.png", 0.001, small_camera, 1); }),
               Catch::EndsWith("d.png: has 7 x 5 pixels, expected 64 x 48 (workload.camera)"));
}

TEST_CASE("An object is a built-in class or a mesh file", "[object_mesh]") {
    CHECK(object_mesh("banana", "workload.object").faces.size() > 100);
    TempFolder const folder;
    auto const path = folder.write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    CHECK(object_mesh(path.string(), "workload.object").faces.size() == 1);
    CHECK(input_error_text([] { object_mesh("bananna", "workload.object"); }) ==
          "workload.object = bananna, expected a built-in class or a mesh file (.obj, .ply, .stl, .off), did you mean "
          "banana?");
    CHECK_THAT(input_error_text([] { object_mesh("none.obj", "workload.object"); }),
               Catch::StartsWith("none.obj: no such file"));
    CHECK_THAT(input_error_text([] { object_mesh("a/banana", "workload.object"); }),
               Catch::StartsWith("a/banana: no such file"));
}

TEST_CASE("A simplified mesh has at most the wanted triangles, the same shape and orientation", "[object_mesh]") {
    Mesh const fine = sphere(0.1, 60);
    for (std::uint64_t const most : {4000U, 1200U, 400U}) {
        Mesh const coarse = simplified(fine, most);
        CAPTURE(most, coarse.faces.size());
        CHECK(coarse.faces.size() <= most);
        CHECK(coarse.faces.size() > most / 2);
        CHECK(coarse.vertices.size() < fine.vertices.size());
        CHECK(volume(coarse) == Approx(volume(fine)).epsilon(0.1));
    }
}

TEST_CASE("A mesh that is small enough, or may have any size, is left as it is", "[object_mesh]") {
    Mesh const mesh = sphere(0.1, 10);
    CHECK(simplified(mesh, mesh.faces.size()).faces == mesh.faces);
    CHECK(simplified(mesh, 0).faces == mesh.faces);
}

TEST_CASE("A mesh of unconnected triangles is simplified nevertheless", "[object_mesh]") {
    Mesh soup;
    for (auto const& face : sphere(0.1, 20).faces) {
        auto const first = static_cast<std::uint32_t>(soup.vertices.size());
        for (std::uint32_t const corner : face) {  // a hair's breadth apart, so that nothing is shared
            soup.vertices.emplace_back(sphere(0.1, 20).vertices[corner] * (1 + 1e-4 * first));
        }
        soup.faces.push_back({first, first + 1, first + 2});
    }
    Mesh const coarse = simplified(soup, 300);
    CHECK(!coarse.faces.empty());
    CHECK(coarse.faces.size() <= 330);
}

TEST_CASE("Triangles that a mesh has several times do not change what it is simplified to", "[object_mesh]") {
    Mesh const once = sphere(0.1, 30);
    Mesh twice = once;
    for (auto const& face : once.faces)
        twice.faces.push_back({face[1], face[2], face[0]});
    Mesh const coarse = simplified(twice, 60);
    CHECK(coarse.faces == simplified(once, 60).faces);
    CHECK(coarse.duplicates == once.faces.size());
    CHECK_THAT(duplicates_warning(coarse, "a.obj"),
               Catch::StartsWith("a.obj: " + std::to_string(once.faces.size()) + " of its triangles have the corners"));
    CHECK(simplified(twice, once.faces.size()).faces == once.faces);
    CHECK(simplified(twice, twice.faces.size()).faces == twice.faces);  // not simplified, and left as it is
    CHECK(duplicates_warning(simplified(once, 60), "a.obj").empty());
}

TEST_CASE("A mesh with all triangles around one vertex is simplified soon", "[object_mesh]") {
    std::uint32_t const rim = 150'000;  // collapsing edges would take minutes
    Mesh cone;
    cone.vertices.emplace_back(0, 0, 0.1);
    for (std::uint32_t i = 0; i < rim; ++i) {
        double const angle = 2 * std::acos(-1.0) * i / rim;
        cone.vertices.emplace_back(0.05 * std::cos(angle), 0.05 * std::sin(angle), 0);
        cone.faces.push_back({0, 1 + i, 1 + (i + 1) % rim});
    }
    Mesh const coarse = simplified(cone, 1200);
    CHECK(coarse.faces.size() > 100);
    CHECK(coarse.faces.size() <= 1320);
    CHECK(longest_side_m(coarse) == Approx(0.1).epsilon(0.02));
}

TEST_CASE("The default workload is a posed object that fits its window, with an observed scene", "[build_stimulus]") {
    WorkloadConfig const config;
    Stimulus const stimulus = build_stimulus(config, 200, {});
    REQUIRE(stimulus.is_posed());
    CHECK(stimulus.triangles.empty());
    CHECK(stimulus.width == 640);
    CHECK(stimulus.height == 480);
    CHECK(stimulus.window == 200);
    REQUIRE(stimulus.samples.size() == 620);
    CHECK(stimulus.posed.poses.size() == 620);
    CHECK(stimulus.samples[5].triangle_count == stimulus.posed.mesh.faces.size());

    Pose const truth = configured_pose(config.target);
    Camera const camera = config.camera;
    for (auto const& vertex : stimulus.posed.mesh.vertices) {
        Eigen::Vector3d const p = truth.rotation * vertex + truth.translation;
        Eigen::Vector3d const& o = truth.translation;
        CHECK(std::abs(camera.fx * (p.x() / p.z() - o.x() / o.z())) < 100);
        CHECK(std::abs(camera.fy * (p.y() / p.z() - o.y() / o.z())) < 100);
    }
    long const edges = std::count(stimulus.observed_edges.pixels().begin(), stimulus.observed_edges.pixels().end(), 1);
    CHECK(edges > 200);
    CHECK(edges < 640 * 480 / 20);
    CHECK(*std::max_element(stimulus.observed_depth.pixels().begin(), stimulus.observed_depth.pixels().end()) <=
          far_depth_code);
}

TEST_CASE("The centre of a sample is the floor of its projected origin", "[build_stimulus]") {
    WorkloadConfig config = small_workload();
    config.target.translation_m = {-0.4, 0.3, 0.7};
    Stimulus const stimulus = build_stimulus(config, 40, {});
    for (std::size_t index = 0; index < 5; ++index) {
        Eigen::Vector3d const& origin = stimulus.posed.poses[index].translation;
        CHECK(stimulus.samples[index].centre_col == std::floor(60 * origin.x() / origin.z() + 31.5));
        CHECK(stimulus.samples[index].centre_row == std::floor(60 * origin.y() / origin.z() + 23.5));
    }
}

TEST_CASE("The observed scene may be a depth image, thinned out with the camera", "[build_stimulus]") {
    TempFolder const folder;
    files::write_png(folder / "d.png", Image<std::uint16_t>(48, 64, 650));
    WorkloadConfig config = small_workload();
    config.camera.fx = config.camera.fy = 600;  // narrow enough for a wall without edges
    config.scene.depth_image = (folder / "d.png").string();
    config.scene.downscale = 2;
    Stimulus const stimulus = build_stimulus(config, 40, {});
    CHECK(stimulus.width == 32);
    CHECK(stimulus.height == 24);
    CHECK(stimulus.posed.camera.fx == Approx(300));
    CHECK(stimulus.observed_depth == Image<std::uint16_t>(24, 32, 332));  // no noise on a real image
    CHECK(stimulus.observed_edges == Image<std::uint8_t>(24, 32));
}

TEST_CASE("Edges are found in the measured depth, whatever the depth buffer's format", "[build_stimulus]") {
    FractionBits coarse;
    coarse.depth_buffer = 0;
    Stimulus const fine_depth = build_stimulus(small_workload(), 40, {});
    Stimulus const coarse_depth = build_stimulus(small_workload(), 40, coarse);
    CHECK(fine_depth.observed_edges == coarse_depth.observed_edges);
    CHECK_FALSE(fine_depth.observed_depth == coarse_depth.observed_depth);
}

TEST_CASE("Other objects of the scene hide the target", "[build_stimulus]") {
    WorkloadConfig config = small_workload();
    config.scene.noise.enabled = false;
    auto const alone = build_stimulus(config, 40, {}).observed_depth;
    config.scene.objects.push_back({"banana", {0, 0, 0.3}, {0, 0, 0}});
    auto const hidden = build_stimulus(config, 40, {}).observed_depth;
    CHECK(hidden.at(24, 32) < alone.at(24, 32));
    config.scene.objects.push_back({"bananna", {0, 0, 0.3}, {0, 0, 0}});
    CHECK_THAT(build_error(config), Catch::StartsWith("workload.scene.objects[1].object = bananna, expected"));
}

TEST_CASE("An object whose origin is too near is an input error that names key or sample", "[build_stimulus]") {
    WorkloadConfig config = small_workload();
    config.target.translation_m[2] = 0.09;
    CHECK(build_error(config) ==
          "workload.pose.translation_m: the object has its origin at z = 0.09 m, expected at least 0.1 m");
    config.target.translation_m[2] = 0.2;
    config.samples.count = 1000;
    config.samples.translation_sigma_m = 0.1;
    CHECK_THAT(build_error(config), Catch::StartsWith("workload.samples: sample ") &&
                                        Catch::Contains("has its origin at z = ") &&
                                        Catch::EndsWith("(reduce workload.samples.translation_sigma_m)"));
    config.target.translation_m = {1e12, 0, 0.5};
    CHECK_THAT(build_error(config), Catch::Contains("sample 0 has its origin at pixel"));
    config = small_workload();
    config.samples = {1, 0, 0, 1, {}};
    config.target.translation_m = {0, 0, 0.5};
    config.camera.cx = -2147483648.0;
    CHECK(build_stimulus(config, 40, {}).samples.at(0).centre_col == std::numeric_limits<std::int32_t>::min());
    config.camera.cx -= 1;
    CHECK_THAT(build_error(config), Catch::Contains("at pixel -2147483649, expected one that fits 32 bits"));
}

/// The median of |measured - rendered| [m] over the pixels that have both.
double median_difference_m(DepthImage const& measured, DepthImage const& rendered) {
    std::vector<double> differences;
    for (std::size_t index = 0; index < measured.pixels().size(); ++index) {
        if (measured.pixels()[index] > 0 && rendered.pixels()[index] > 0) {
            differences.push_back(std::abs(measured.pixels()[index] - rendered.pixels()[index]));
        }
    }
    REQUIRE(!differences.empty());
    auto const middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
    std::nth_element(differences.begin(), middle, differences.end());
    return *middle;
}

Camera camera_of(nlohmann::json const& frame) {
    auto const& k = frame.at("intrinsics");
    return {frame.at("width"), frame.at("height"), k.at("fx"), k.at("fy"), k.at("cx"), k.at("cy")};
}

Pose scan_pose(nlohmann::json const& object) {
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        auto const index = static_cast<std::size_t>(row);
        pose.translation[row] = object.at("t_scan").at(index);
        for (int column = 0; column < 3; ++column) {
            pose.rotation(row, column) = object.at("R").at(index).at(static_cast<std::size_t>(column));
        }
    }
    return pose;
}

TEST_CASE("Scenes rendered by others look the same here, to a millimetre", "[scene_renderer][shared_data]") {
    char const* const data = std::getenv("FASTER_SHARED_DATA");
    if (data == nullptr) {
        WARN("skipped: FASTER_SHARED_DATA (folder with meshes/ and depth/) is not set");
        return;
    }
    std::filesystem::path const root = data;
    std::filesystem::path const folder = root / "depth" / "ycbv_syn";
    auto const frames = nlohmann::json::parse(std::ifstream(folder / "frames.json")).at("frames");
    for (auto const& frame : frames) {
        Camera const camera = camera_of(frame);
        DepthImage rendered(camera.height, camera.width);
        for (auto const& object : frame.at("objects")) {
            std::string const name = object.at("class");
            draw_mesh(files::load_mesh(root / "meshes" / (name + ".obj")), scan_pose(object), camera, rendered);
        }
        std::string const file = frame.at("depth");
        DepthImage const measured = load_depth_image(folder / file, frame.at("depth_unit_m"), camera, 1);
        double const median_m = median_difference_m(measured, rendered);
        INFO(file << ": median difference " << 1000 * median_m << " mm");
        CHECK(median_m < 0.001);
        double const share = static_cast<double>(readings(rendered)) / static_cast<double>(readings(measured));
        CHECK(share == Approx(1).epsilon(0.01));
    }
}

TEST_CASE("All scans can be simplified to the triangles the machine gets", "[object_mesh][shared_data]") {
    char const* const data = std::getenv("FASTER_SHARED_DATA");
    if (data == nullptr) {
        WARN("skipped: FASTER_SHARED_DATA (folder with meshes/ and depth/) is not set");
        return;
    }
    for (auto const& entry : std::filesystem::directory_iterator(std::filesystem::path(data) / "meshes")) {
        if (!files::has_mesh_extension(entry.path())) {
            continue;
        }
        Mesh const scan = files::load_mesh(entry.path());
        Mesh const coarse = simplified(scan, 1200);
        CAPTURE(entry.path(), coarse.faces.size(), volume(scan), volume(coarse));
        CHECK(scan.faces.size() == 16384);
        CHECK(coarse.faces.size() <= 1320);
        CHECK(coarse.faces.size() > 600);
        CHECK(volume(coarse) == Approx(volume(scan)).epsilon(0.2));  // the thin bowl loses most
    }
}

}  // namespace scene_test
