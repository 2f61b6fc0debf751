#include "faster/workload/files/mesh_file.hpp"

#include <catch2/catch.hpp>
#include <string>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/is_instrumented.hpp"
#include "support/temp_folder.hpp"

namespace mesh_file_test {

using Catch::Matchers::Contains;
using faster::Mesh;
using faster::files::load_mesh;
using faster::test::input_error_text;
using faster::test::is_instrumented;
using faster::test::TempFolder;

std::string const tetrahedron_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
std::string const tetrahedron_faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string ascii_ply(std::string const& vertices, std::string const& faces) {
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
           "element face 2\nproperty list uchar int vertex_indices\nend_header\n" +
           vertices + faces;
}

std::string load_error(std::filesystem::path const& path) {
    std::string text = input_error_text([&] { load_mesh(path); });
    CHECK(text.find('\n') == std::string::npos);
    return text;
}

TEST_CASE("An OBJ mesh keeps its triangles, their order and their orientation", "[mesh_file]") {
    TempFolder const folder;
    Mesh const mesh = load_mesh(folder.write("t.obj", tetrahedron_vertices + tetrahedron_faces));
    REQUIRE(mesh.vertices.size() == 4);
    REQUIRE(mesh.faces.size() == 4);
    auto const corner = [&](std::size_t face, std::size_t index) { return mesh.vertices[mesh.faces[face][index]]; };
    CHECK(corner(0, 0) == Eigen::Vector3d(0, 0, 0));
    CHECK(corner(0, 1) == Eigen::Vector3d(0, 1, 0));
    CHECK(corner(0, 2) == Eigen::Vector3d(1, 0, 0));
    CHECK(corner(3, 2) == Eigen::Vector3d(0, 0, 1));
}

TEST_CASE("PLY, STL and OFF meshes load like OBJ", "[mesh_file]") {
    TempFolder const folder;
    std::string const vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    CHECK(load_mesh(folder.write("t.ply", ascii_ply(vertices, "3 0 1 2\n3 0 2 3\n"))).vertices.size() == 4);
    CHECK(load_mesh(folder.write("t.off", "OFF\n4 2 0\n" + vertices + "3 0 1 2\n3 0 2 3\n")).faces.size() == 2);
    std::string const facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
    std::string const second = "facet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\n";
    Mesh const stl =
        load_mesh(folder.write("T.STL", "solid s\n" + facet + "endfacet\n" + second + "endfacet\nendsolid s\n"));
    CHECK(stl.faces.size() == 2);
    CHECK(stl.vertices.size() == 4);  // an STL repeats shared vertices: they are joined
}

TEST_CASE("Vertices that differ only in their texture or normal are joined", "[mesh_file]") {
    TempFolder const folder;
    std::string const textures = "vt 0 0\nvt 1 0\nvt 0 1\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n";
    Mesh const mesh = load_mesh(
        folder.write("t.obj", tetrahedron_vertices + textures + "f 1/1/1 2/2/1 3/3/1\nf 1/4/2 2/1/2 4/2/2\n"));
    CHECK(mesh.vertices.size() == 4);
}

TEST_CASE("Close but different vertices stay apart", "[mesh_file]") {
    TempFolder const folder;
    Mesh const mesh = load_mesh(folder.write("t.obj", "v 0 0 0\nv 1e-6 0 0\nv 0 1e-6 0\nf 1 2 3\n"));
    CHECK(mesh.vertices.size() == 3);
}

TEST_CASE("Several objects and groups become one mesh, polygons are cut, points and lines left out", "[mesh_file]") {
    TempFolder const folder;
    std::string const square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
    Mesh const mesh =
        load_mesh(folder.write("t.obj", square + "o a\nf 1 2 3 4\no b\nv 0 0 1\nf 1 2 5\ng c\nl 1 2\np 3\n"));
    CHECK(mesh.faces.size() == 3);
    CHECK(mesh.vertices.size() == 5);
}

TEST_CASE("Triangles without area and edges shared by three triangles survive", "[mesh_file]") {
    TempFolder const folder;
    std::string const faces = "f 1 2 3\nf 1 2 4\nf 2 1 3\nf 1 1 2\nf 3 3 3\n";
    CHECK(load_mesh(folder.write("t.obj", tetrahedron_vertices + faces)).faces.size() == 5);
}

TEST_CASE("A mesh file that is missing or a folder is an input error", "[mesh_file]") {
    TempFolder const folder;
    CHECK(load_error(folder / "none.obj") ==
          (folder / "none.obj").string() + ": no such file, expected a readable file");
    CHECK_THAT(load_error(folder.path()), Catch::EndsWith(": is a folder, expected a file"));
}

TEST_CASE("A mesh file that the host cannot read is no fault of the input", "[mesh_file]") {
    TempFolder const folder;
    std::filesystem::create_symlink("/proc/self/mem", folder / "m.obj");  // whose first bytes nobody can read
    CHECK_THROWS_AS(load_mesh(folder / "m.obj"), dataflow::HostError);
}

TEST_CASE("A mesh file of an unknown format is an input error", "[mesh_file]") {
    TempFolder const folder;
    CHECK_THAT(load_error(folder.write("t.step", "ISO-10303-21;")),
               Catch::EndsWith("t.step: is of an unknown format, expected a mesh file (.obj, .ply, .stl, .off)"));
}

TEST_CASE("A file that is no mesh is an input error", "[mesh_file]") {
    TempFolder const folder;
    for (std::string const name : {"t.obj", "t.ply", "t.stl", "t.off"}) {
        CAPTURE(name);
        for (char const* const content : {"hello world\n", ""})
            CHECK_THAT(load_error(folder.write(name, content)),
                       Catch::Contains(name + ": cannot be read as a mesh (") &&
                           Catch::EndsWith("), expected a valid " + name.substr(2) + " file"));
    }
}

TEST_CASE("A face that names a vertex beyond the last is an input error", "[mesh_file]") {
    TempFolder const folder;
    CHECK_THAT(
        load_error(folder.write("t.obj", tetrahedron_vertices + "f 1 2 9\n")),
        Catch::EndsWith("t.obj:5: face 0 (counted from 0) names vertex 9, which does not exist, expected one of 4 "
                        "vertices"));
    CHECK_THAT(load_error(folder.write("t.obj", tetrahedron_vertices + "f 1 2 3\nf 1 2 -5\n")),
               Catch::Contains("t.obj:6: face 1 (counted from 0) names vertex -5"));
    CHECK_THAT(load_error(folder.write("t.obj", tetrahedron_vertices + "f 1 2 0\n")),
               Catch::Contains("t.obj:5: face 0 (counted from 0) has 0 as a corner"));
    CHECK_THAT(load_error(folder.write("t.ply", ascii_ply("0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "3 0 1 2\n4 0 1 2 9\n"))),
               Catch::Contains("t.ply:15: face 1 (counted from 0) names vertex 9, which does not exist"));
    CHECK_THAT(load_error(folder.write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n")),
               Catch::Contains("t.off:6: face 0 (counted from 0) names vertex 3, which does not exist"));
}

TEST_CASE("A PLY file that ends early is an input error, in text and in binary", "[mesh_file]") {
    TempFolder const folder;
    std::string const vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    CHECK_THAT(load_error(folder.write("t.ply", ascii_ply(vertices, "3 0 1 2\n"))),
               Catch::EndsWith("t.ply:15: the file ends early, expected more rows, each on a line of its own"));

    std::string binary = ascii_ply("", "");
    binary.replace(binary.find("ascii"), 5, "binary_big_endian");
    std::string const zero(4, '\0'), one{"\x3f\x80\0\0", 4};
    binary += zero + zero + zero + one + zero + zero + zero + one + zero + zero + zero + one;
    for (std::string const& face :
         {std::string{"\3\0\0\0\0\0\0\0\1\0\0\0\2", 13}, std::string{"\3\0\0\0\0\0\0\0\2\0\0\0\3", 13}}) {
        CHECK_THAT(load_error(folder.write("t.ply", binary)), Catch::Contains("(it ends early)"));
        binary += face;
    }
    CHECK(load_mesh(folder.write("t.ply", binary)).faces.size() == 2);
    CHECK_THAT(load_error(folder.write("t.ply", binary.substr(0, binary.size() - 1))),
               Catch::Contains("(it ends early)"));
}

TEST_CASE("A mesh file without triangles is an input error", "[mesh_file]") {
    TempFolder const folder;
    CHECK_THAT(load_error(folder.write("t.obj", tetrahedron_vertices)),
               Catch::EndsWith("t.obj: has no triangles, expected at least one"));
}

TEST_CASE("A coordinate that is not finite is an input error that names the vertex of the file", "[mesh_file]") {
    TempFolder const folder;
    std::string const faces = "f 1 3 2\nf 1 2 4\n";
    CHECK_THAT(load_error(folder.write("t.obj", "# nan\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 nan 1\n" + faces)),
               Catch::EndsWith("t.obj:5: vertex 3 (counted from 0) is (0, nan, 1), expected finite coordinates"));
    CHECK_THAT(load_error(folder.write("t.obj", "v 0 0 0\nv inf 0 0\nv 0 1 0\nv 0 0 1\n" + faces)),
               Catch::Contains("t.obj:2: vertex 1 (counted from 0) is (inf, 0, 0)"));
    CHECK_THAT(load_error(folder.write("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1e999\n" + faces)),
               Catch::Contains("t.obj:4: vertex 3"));
    CHECK_THAT(load_error(folder.write("t.ply", ascii_ply("0 0 0\n1 0 0\n0 nan 0\n0 0 1\n", "3 0 1 2\n3 0 2 3\n"))),
               Catch::Contains("t.ply:12: vertex 2 (counted from 0) is (0, nan, 0)"));
}

TEST_CASE("Damaged files that libraries crash, hang or take gigabytes on are refused at their line", "[mesh_file]") {
    std::string const folder = FASTER_SOURCE_DIR "/tests/data/meshes/";
    auto const error = [&](std::string const& name) { return load_error(folder + name); };
    CHECK_THAT(error("crash.off"), Contains("crash.off:8: face 1 (counted from 0) has no corners"));
    CHECK_THAT(error("hang.ply"), Contains("hang.ply:9: a property of type lis\\x05, expected char, uchar"));
    CHECK_THAT(error("memory.off"), Contains("memory.off:1: the file ends early"));
    CHECK_THAT(error("memory.ply"), Contains("memory.ply:4: a property of no element"));
}

TEST_CASE("Reading takes no more time and memory than the limits say", "[mesh_file]") {
    TempFolder const folder;
    std::string vertices;
    for (int i = 0; i < 400'000; ++i)
        vertices += "v 0 0 0\n";
    auto const file = folder.write("t.obj", vertices + "f 1 2 3\n");
    std::string const start = file.string() + ": cannot be read as a mesh (";
    faster::files::MeshLimits limits;
    limits.section = "workload.mesh_files";
    limits.seconds = 0.001;
    CHECK(input_error_text([&] { load_mesh(file, limits); }) ==
          start +
              "it took more than 0.001 s), expected a valid obj file, or a larger workload.mesh_files.time_limit_s");
    if (is_instrumented)
        return;  // a sanitizer takes memory of its own
    limits.seconds = 10;
    limits.memory_mib = 2;
    CHECK(input_error_text([&] { load_mesh(file, limits); }) ==
          start +
              "it took more than 2 MiB of memory), expected a valid obj file, or a larger "
              "workload.mesh_files.memory_limit_mib");
}

TEST_CASE("A mesh file may be as long as its limit", "[mesh_file]") {
    TempFolder const folder;
    auto const file = folder.write("t.obj", tetrahedron_vertices + tetrahedron_faces + std::string(1 << 20, '\n'));
    faster::files::MeshLimits limits;
    limits.file_mib = 1;
    CHECK(input_error_text([&] { load_mesh(file, limits); }) ==
          file.string() + ": cannot be read as a mesh (it is longer than 1 MiB), expected a valid obj file");
    limits.file_mib = 2;
    CHECK(load_mesh(file, limits).faces.size() == 4);
}

TEST_CASE("A PLY file whose header never ends is cut off", "[mesh_file]") {
    TempFolder const folder;
    CHECK_THAT(load_error(folder.write("t.ply", "ply\nformat ascii 1.0\nelement vertex 4\n")),
               Contains("(it ends early)"));
}

TEST_CASE("Elements that take no room are no work, however many there are", "[mesh_file]") {
    TempFolder const folder;
    std::string file = ascii_ply("0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "3 0 1 2\n3 0 2 3\n");
    file.insert(file.find("element face"), "element nothing 9223372036854775807\n");
    CHECK(load_mesh(folder.write("t.ply", file)).faces.size() == 2);
    file.insert(file.find("nothing 9") + 8, "9");
    CHECK_THAT(load_error(folder.write("t.ply", file)),
               Contains("t.ply:7: element nothing of 99223372036854775807 rows"));
}

TEST_CASE("Several meshes are read at once, and the first bad one is named", "[mesh_file]") {
    TempFolder const folder;
    auto const one = folder.write("a.obj", tetrahedron_vertices + "f 1 2 3\n");
    auto const two = folder.write("b.obj", tetrahedron_vertices + tetrahedron_faces);
    auto const meshes = faster::files::load_meshes({one, two, one}, {}, 2);
    REQUIRE(meshes.size() == 3);
    CHECK(meshes[0].faces.size() == 1);
    CHECK(meshes[1].faces.size() == 4);
    auto const bad = folder.write("c.obj", "f 1 2 3\n");
    CHECK_THAT(input_error_text([&] {
                   faster::files::load_meshes({one, bad, two}, {}, 2);
               }),
               Contains("c.obj:1: face 0"));
}

TEST_CASE("A mesh comes whole from one process to another, or not at all", "[mesh_file]") {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}};
    mesh.faces = {{0, 1, 2}, {2, 1, 0}};
    std::string const bytes = faster::files::mesh_bytes(mesh);
    auto const copy = faster::files::mesh_from_bytes(bytes);
    REQUIRE(copy);
    CHECK(copy->vertices == mesh.vertices);
    CHECK(copy->faces == mesh.faces);
    for (std::size_t length = 0; length < bytes.size(); ++length)
        CHECK_FALSE(faster::files::mesh_from_bytes(bytes.substr(0, length)));
    CHECK_FALSE(faster::files::mesh_from_bytes(bytes + '\0'));
    for (std::size_t const place : {0U, 7U, 8U, 15U}) {  // counts of vertices and faces
        std::string damaged = bytes;
        damaged[place] = static_cast<char>(damaged[place] ^ 0x40);
        CHECK_FALSE(faster::files::mesh_from_bytes(damaged));
    }
    std::string damaged = bytes;
    damaged.back() = 1;  // the last vertex of the last face
    CHECK_FALSE(faster::files::mesh_from_bytes(damaged));
}

}  // namespace mesh_file_test
