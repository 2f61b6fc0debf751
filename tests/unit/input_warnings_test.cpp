#include "faster/workload/input_warnings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch.hpp>

#include "faster/workload/models/builtin_models.hpp"
#include "faster/workload/object_mesh.hpp"

namespace input_warnings_test {

using namespace faster;
using namespace faster::workload;
using Catch::Matchers::Contains;
using Warnings = std::vector<std::string>;

Mesh times(Mesh mesh, double scale) {
    for (Eigen::Vector3d& vertex : mesh.vertices)
        vertex *= scale;
    return mesh;
}

Mesh turned(Mesh mesh) {
    for (auto& face : mesh.faces)
        std::swap(face[0], face[1]);
    return mesh;
}

TEST_CASE("A mesh in millimetres or centimetres, or in metres read as millimetres, is told with the scale") {
    for (std::string const& name : models::names())
        CHECK(mesh_warnings(models::make(name), name).empty());
    Mesh const banana = models::make("banana");
    Warnings warnings = mesh_warnings(times(banana, 1000), "b.ply");
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains("m long, which looks like millimetres; expected less than 3 m "
                                     "(workload.mesh_files.scale: 0.001 reads millimetres)"));
    warnings = mesh_warnings(times(models::make("mug"), 50), "b.ply");
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains("looks like centimetres") && Contains("0.01 reads centimetres"));
    warnings = mesh_warnings(times(banana, 0.001), "b.ply");
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains("expected at least 0.005 m (workload.mesh_files.scale: 1 reads metres)"));
}

TEST_CASE("A closed mesh whose faces look inwards is told with its volume, an open one never") {
    Mesh box = models::make("cracker_box");
    Warnings const warnings = mesh_warnings(turned(box), "b.ply");
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains("b.ply: its faces are turned inwards (a volume of -0.0") &&
                                Contains("expected corners counter-clockwise"));
    Mesh far_away = turned(box);
    for (Eigen::Vector3d& vertex : far_away.vertices)
        vertex += Eigen::Vector3d(0, 0, 2);
    CHECK(mesh_warnings(far_away, "b.ply").size() == 1);
    Mesh open = turned(box);
    open.faces.erase(std::remove_if(open.faces.begin(), open.faces.end(),
                                    [&](auto const& face) { return open.vertices[face[0]].x() < 0; }),
                     open.faces.end());
    CHECK(mesh_warnings(open, "b.ply").empty());
    Mesh both = box;
    Mesh const inner = turned(box);
    both.faces.insert(both.faces.end(), inner.faces.begin(), inner.faces.end());
    CHECK(mesh_warnings(both, "b.ply").empty());
    Mesh sheet;  // with two sides
    sheet.vertices = {{0, 0, 0}, {0.1, 0, 0}, {0, 0.1, 0}};
    sheet.faces = {{0, 1, 2}, {0, 2, 1}};
    CHECK(mesh_warnings(sheet, "b.ply").empty());
}

TEST_CASE("A camera of another unit, or of another image, is told with its keys") {
    CHECK(camera_warnings(Camera{}).empty());
    Camera camera;
    camera.fx = camera.fy = 1.93;  // millimetres
    Warnings warnings = camera_warnings(camera);
    REQUIRE(warnings.size() == 2);
    CHECK_THAT(warnings[0],
               Contains("workload.camera.fx = 1.93: sees 179 degrees of 640 pixels; expected a focal length in "
                        "pixels"));
    CHECK_THAT(warnings[1], Contains("workload.camera.fy = 1.93"));
    camera = {};
    camera.fx = 570340;
    CHECK(camera_warnings(camera).size() == 1);
    camera = {};
    camera.cx = 960;  // of 1920 x 1080
    camera.cy = -239.5;
    warnings = camera_warnings(camera);
    REQUIRE(warnings.size() == 2);
    CHECK_THAT(warnings[0],
               Contains("workload.camera.cx = 960: the optical axis is outside of the image; expected 0 to 639 "
                        "(workload.camera.width = 640)"));
    CHECK_THAT(warnings[1], Contains("workload.camera.cy = -239.5"));
}

/// A wall with something in front of it, in the middle.
DepthImage scene(double wall_m, double object_m) {
    DepthImage depth(48, 64);
    for (double& pixel : depth.pixels())
        pixel = wall_m;
    for (int row = 20; row < 28; ++row)
        for (int column = 28; column < 36; ++column)
            depth.at(row, column) = object_m;
    return depth;
}

Camera const small_camera{64, 48, 57, 57, 31.5, 23.5};

TEST_CASE("A depth image of another unit is told with what was measured and the key") {
    CHECK(depth_range_warning(scene(1.2, 0.7), "d.png", "unit = 1").empty());
    CHECK(depth_range_warning(scene(6, 0.7), "d.png", "unit = 1").empty());  // a deep room
    CHECK(depth_range_warning(scene(12, 7), "d.png", "unit = 1") ==
          "d.png: 100 % of its 3072 readings are beyond 3 m, and their median is 12 m; expected a scene of 0.1 to 3 m "
          "(unit = 1)");
    CHECK_THAT(depth_range_warning(scene(0.0012, 0.0007), "d.png", "unit = 1"),
               Contains("100 % of its 3072 readings are below 0.1 m, and their median is 0.0012 m"));
    CHECK_THAT(depth_range_warning(DepthImage(48, 64), "d.png", "unit = 1"),
               Contains("d.png: none of its 3072 pixels has a reading"));
}

TEST_CASE("A depth image that has nothing at the object's distance where the poses put it is told") {
    Mesh const mug = models::make("mug");
    Pose pose;
    pose.translation = Eigen::Vector3d(0, 0, 0.7);
    auto const warning = [&](DepthImage const& depth, std::vector<Pose> const& poses) {
        return depth_pose_warning(depth, small_camera, mug, poses, "d.png", "unit = 1");
    };
    CHECK(warning(scene(1.2, 0.7), {pose}).empty());
    CHECK(warning(scene(0.75, 0.75), {pose}).empty());
    CHECK(warning(scene(2.4, 1.4), {pose}) ==
          "d.png: where the poses put the object, none of the readings is near it: their median is 1.4 m, the first "
          "pose's "
          "distance 0.7 m; expected readings of the object (unit = 1, or the poses)");
    CHECK_FALSE(warning(scene(0.4, 0.35), {pose}).empty());
    CHECK(warning(scene(0, 0), {pose}).empty());
    Pose aside = pose;
    aside.translation.x() = 5;  // not in the image
    CHECK(warning(scene(2.4, 1.4), {aside}).empty());
    CHECK(warning(scene(1.2, 0.7), {aside, pose}).empty());  // one is enough
    CHECK(warning(scene(2.4, 1.4), {}).empty());
}

TEST_CASE("Poses in millimetres are told with their table or key") {
    WorkloadConfig config;
    Pose near, far;
    near.translation = Eigen::Vector3d(0, 0, 0.7);
    far.translation = Eigen::Vector3d(0, 0, 700);
    Mesh const mug = models::make("mug");
    CHECK(input_warnings(config, mug, {near, near, far}, {}).empty());
    Warnings warnings = input_warnings(config, mug, {far, far, near}, {});
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0] ==
          "workload.pose.translation_m: 2 of 3 poses are further than 10 m away, the first 700 m; expected "
          "metres");
    config.samples.poses = "p.csv";
    warnings = input_warnings(config, mug, {far}, {});
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0], Contains("p.csv: 1 of 1 poses") && Contains("metres in t_m and millimetres in t"));
}

TEST_CASE("Triangles whose z has no code are told with the key, far poses with how far they are") {
    WorkloadConfig config;
    Mesh const mug = models::make("mug");
    Pose pose;
    pose.translation = Eigen::Vector3d(0, 0, 1.5);
    FractionBits fraction;
    for (int const bits : {14, 15, 16}) {
        fraction.vertex_z = bits;
        Warnings const warnings = input_warnings(config, mug, {pose}, fraction);
        REQUIRE(warnings.size() == (bits == 16 ? 1U : 0U));
        if (bits == 16)
            CHECK_THAT(warnings[0], Contains("accelerator.fraction_bits.vertex_z = 16: triangles that reach beyond 1 m "
                                             "are dropped, as of 1 of 1 poses; expected at most 14"));
    }
    pose.translation.z() = 2.1;
    fraction.vertex_z = 15;
    CHECK_THAT(input_warnings(config, mug, {pose}, fraction).at(0), Contains("beyond 2 m"));
    pose.translation = Eigen::Vector3d(1e308, 0, 1e308);
    CHECK_THAT(input_warnings(config, mug, {pose}, {}).at(0), Contains("the first 1.414e+308 m"));
}

TEST_CASE("A mesh of just 5 mm is none of less, whatever single precision makes of its ends") {
    Mesh const mug = models::make("mug");
    auto const of_length = [&](double side_m) {
        Mesh mesh = times(mug, side_m / longest_side_m(mug));
        for (Eigen::Vector3d& vertex : mesh.vertices)
            vertex = vertex.cast<float>().cast<double>();
        return mesh_warnings(mesh, "m.ply").size();
    };
    CHECK(of_length(0.005 * (1 - 1e-7)) == 0);
    CHECK(of_length(0.004999) == 1);
}

}  // namespace input_warnings_test
