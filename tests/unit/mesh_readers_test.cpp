// What stands in mesh files beside their surface, and surfaces written in other ways.
#include "faster/workload/files/mesh_readers.hpp"

#include <Eigen/Geometry>
#include <catch2/catch.hpp>
#include <cstring>
#include <string>

#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"

namespace mesh_readers_test {

using namespace faster;
using Catch::Matchers::Contains;
using test::input_error_text;

Mesh read(std::string const& name, std::string const& file) {
    files::MeshBuilder builder;
    std::string const ending = name.substr(name.find('.'));
    (ending == ".obj"   ? files::read_obj
     : ending == ".ply" ? files::read_ply
     : ending == ".stl" ? files::read_stl
                        : files::read_off)(name, file, builder);
    return builder.mesh();
}

std::string error(std::string const& name, std::string const& file) {
    return input_error_text([&] { read(name, file); });
}

/// A wedge of five faces; its quadrilaterals are cut.
std::string const wedge = "v 0 0 0\nv 2 0 0\nv 0 1 0\nv 0 0 3\nv 2 0 3\nv 0 1 3\n";
std::string const wedge_faces = "f 1 3 2\nf 4 5 6\nf 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n";

double volume(Mesh const& mesh) {
    double six = 0;
    for (auto const& face : mesh.faces)
        six += mesh.vertices[face[0]].dot(mesh.vertices[face[1]].cross(mesh.vertices[face[2]]));
    return six / 6;
}

void check_wedge(Mesh const& mesh) {
    CHECK(mesh.vertices.size() == 6);
    CHECK(mesh.faces.size() == 8);
    CHECK(volume(mesh) == Approx(3));
}

std::string replaced(std::string text, std::string const& from, std::string const& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

TEST_CASE("What is not geometry in an OBJ file refuses nothing, and no other file is opened", "[mesh_readers]") {
    check_wedge(read("a.obj", wedge + wedge_faces));
    check_wedge(read("a.obj", "mtllib /etc/shadow\nmtllib\no\ng a b\nusemtl \"x # y\"\ns off\n" + wedge +
                                  "\nvt 0\nvn nan x\n" + "vp 1\nd_interp on\nlod 3\n" + wedge_faces +
                                  "usemtl\nnonsense 1 2 3\n"));
    check_wedge(read("a.obj", replaced(wedge + wedge_faces, "\n", " # a comment f 9 9 9\n")));
    check_wedge(read("a.obj", replaced(wedge + wedge_faces, "\n", "#\n")));
    check_wedge(read("a.obj", replaced(wedge, "\n", " 0.5 0.5 0.5\n") + wedge_faces));  // colours
    check_wedge(read("a.obj", replaced(wedge, "\n", " 1 red\n") + wedge_faces));
    check_wedge(read("a.obj", wedge + replaced(wedge_faces, "f 1 3 2", "f 1/7/8 3/9/9 2/1/")));  // no vt, no vn
    check_wedge(read("a.obj", wedge + replaced(wedge_faces, "f 1 3 2", "f 1//1 3//2 2//3")));
    check_wedge(read("a.obj", wedge + wedge_faces + "l 1 2\np 3\nf 1 2\nf 1\nf\ncstype bspline\ncurv 0 1 1 2\n"));
}

TEST_CASE("Lines of an OBJ file may end and go on in any of the usual ways", "[mesh_readers]") {
    std::string const file = wedge + wedge_faces;
    check_wedge(read("a.obj", replaced(file, "\n", "\r\n")));
    check_wedge(read("a.obj", replaced(file, "\n", "\r")));
    check_wedge(read("a.obj", file.substr(0, file.size() - 1)));
    check_wedge(read("a.obj", file.substr(0, file.size() - 1) + "\\"));
    check_wedge(read("a.obj", file.substr(0, file.size() - 1) + " \\"));
    check_wedge(read("a.obj", "\xEF\xBB\xBF" + file));
    check_wedge(read("a.obj", replaced(replaced(file, "f 1 ", "f 1 \\\n\t"), "2 0 3", "2\\\r\n 0 3")));
    check_wedge(read("a.obj", replaced(file, " ", " \t  ")));
    CHECK_THAT(error("a.obj", "v 0 0 \\\n\\\n x\n"),
               Contains("a.obj:3: vertex 0 (counted from 0) has x as a coordinate"));
}

TEST_CASE("Indices of an OBJ file count from either end, and may name vertices that follow", "[mesh_readers]") {
    check_wedge(read("a.obj", wedge + "f -6 -4 -5\nf -3/1 -2/1 -1/1\nf 1 2 -2 -3\nf 2 3 6 5\nf 3 1 4 6\n"));
    check_wedge(read("a.obj", wedge_faces + wedge));
    CHECK_THAT(error("a.obj", "f 1 2 7\nf 1 3 8\n" + wedge),
               Contains("a.obj:2: face 1 (counted from 0) names vertex 8"));
    CHECK_THAT(error("a.obj", "f -1 1 2\n" + wedge), Contains("a.obj:1: face 0 (counted from 0) names vertex -1"));
    CHECK_THAT(error("a.obj", wedge + "f 1 2 1e30\n"),
               Contains("a.obj:7: face 0 (counted from 0) has 1e30 as a corner"));
    CHECK_THAT(error("a.obj", wedge + "f 1 2 99999999999\n"), Contains("names vertex 99999999999"));
    CHECK_THAT(error("a.obj", wedge + "f 1 2 x/3\n"), Contains("has x/3 as a corner"));
}

TEST_CASE("Numbers are read in every notation, and nothing else is taken for one", "[mesh_readers]") {
    Mesh const mesh = read("a.obj", "v +1 -.5 2.\nv 1e2 1E-2 +1.5e+1\nv 1e-60 0 0\nf 1 2 3\n");
    CHECK(mesh.vertices[0] == Eigen::Vector3d(1, -0.5, 2));
    CHECK(mesh.vertices[1] == Eigen::Vector3d(100, double{0.01F}, 15));
    CHECK(mesh.vertices[2] == Eigen::Vector3d(0, 0, 0));
    for (char const* const word : {"1,5", "0x1", "1e", "+-1", "--1", "1.2.3", "3.1+e2", "one", "-", "+"})
        CHECK_THAT(error("a.obj", "v 0 0 0\nv 0 0 " + std::string(word) + "\n"),
                   Contains("a.obj:2: vertex 1 (counted from 0) has " + std::string(word) + " as a coordinate"));
    CHECK_THAT(error("a.obj", "v 0 0\n"), Contains("a.obj:1: vertex 0 (counted from 0) has nothing as a coordinate"));
    for (char const* const word : {"nan", "-inf", "1e39", "1e999"})
        CHECK_THAT(error("a.obj", "v 0 0 " + std::string(word) + "\n"),
                   Contains("a.obj:1: vertex 0 (counted from 0) is ("));
}

TEST_CASE("Surfaces that are not read are told, not left out", "[mesh_readers]") {
    for (char const* const statement : {"surf 0 1 0 1 1 2 3 4", "bsp 1 2 3", "cdp 1 2"})
        CHECK_THAT(error("a.obj", wedge + wedge_faces + statement + "\n"),
                   Contains("a.obj:12: " + std::string(statement).substr(0, 3)) &&
                       Contains("a surface that is not read, expected polygons"));
    CHECK_THAT(error("a.obj", wedge + wedge_faces + "call b.obj\n"),
               Contains("a.obj:12: call: what it includes is not read"));
    CHECK_THAT(error("a.ply",
                     "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
                     "z\nelement trifans 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0\n"),
               Contains("a.ply:7: element trifans lists vertices, which is not read"));
    CHECK_THAT(error("a.off", "OFF BINARY\n"), Contains("a.off:1: OFF BINARY: is not read"));
    CHECK_THAT(error("a.off", "4OFF\n"), Contains("a.off:1: 4OFF: vertices of other than three dimensions"));
}

/// The wedge as PLY in one of the formats: its vertices are doubles behind a colour, its faces have more lists than
/// one.
class PlyWriter {
  public:
    explicit PlyWriter(std::string format) : format_(std::move(format)) {}

    std::string wedge(bool as_strips) {
        text_ = "ply\nformat " + format_ +
                " 1.0\ncomment f 1 2 3\nobj_info # x\nelement material 1\nproperty uchar shine\nelement vertex 6\n"
                "property uint8 red\nproperty double x\nproperty float64 z\nproperty float y\n";
        text_ += as_strips ? "element tristrips 2\nproperty list int int vertex_indices\n"
                           : "element face 5\nproperty list ushort float uv\nproperty list uchar short vertex_index\n"
                             "property char flag\n";
        text_ += "element edge 1\nproperty int vertex1\nproperty int vertex2\nend_header\n";
        put<std::uint8_t>(7);
        end_row();
        for (int i = 0; i < 6; ++i) {
            put<std::uint8_t>(200);
            put<double>(i % 3 == 1 ? 2 : 0);
            put<double>(i < 3 ? 0 : 3);
            put<float>(i % 3 == 2 ? 1 : 0);
            end_row();
        }
        as_strips ? strips() : faces();
        put<std::int32_t>(-5);
        put<std::int32_t>(5);
        return text_;
    }

  private:
    void strips() {
        // Between the last two sides are triangles without area that only lead from one to the other.
        for (std::vector<int> const& strip :
             {std::vector<int>{0, 2, 1, -1, 3, 4, 5, -1, 0, 1, 3, 4}, {1, 2, 4, 5, 5, 2, 2, 0, 5, 3}}) {
            put<std::int32_t>(static_cast<int>(strip.size()));
            for (int const vertex : strip)
                put<std::int32_t>(vertex);
            end_row();
        }
    }

    void faces() {
        for (std::vector<int> const& face :
             {std::vector<int>{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}}) {
            put<std::uint16_t>(2);
            put<float>(0.5F);
            put<float>(0.25F);
            put<std::uint8_t>(static_cast<int>(face.size()));
            for (int const vertex : face)
                put<std::int16_t>(vertex);
            put<std::int8_t>(-1);
            end_row();
        }
    }

    template <typename Number> void put(double value) {
        auto const number = static_cast<Number>(value);
        if (format_ == "ascii") {
            text_ += std::to_string(value) + ' ';
            return;
        }
        char bytes[sizeof number];
        std::memcpy(bytes, &number, sizeof number);
        std::string stored(bytes, sizeof number);
        text_ += format_ == "binary_big_endian" ? std::string(stored.rbegin(), stored.rend()) : stored;
    }
    void end_row() { text_ += format_ == "ascii" ? "\n" : ""; }

    std::string format_;
    std::string text_;
};

TEST_CASE("PLY is read in its three formats, with whatever else its elements have", "[mesh_readers]") {
    for (char const* const format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        CAPTURE(format);
        check_wedge(read("a.ply", PlyWriter(format).wedge(false)));
    }
    std::string const text = PlyWriter("ascii").wedge(false);
    check_wedge(read("a.ply", replaced(text, "\n", "\r\n")));
    check_wedge(read("a.ply", replaced(text, "\n", "\r")));
    check_wedge(read("a.ply", replaced(text, "end_header\n", "end_header\n\ncomment 1 2 3\n")));
    check_wedge(read("a.ply", replaced(text, " 3.000000 ", "\n3.000000 ")));
}

TEST_CASE("Strips of a PLY file give the triangles of the same solid", "[mesh_readers]") {
    for (char const* const format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        CAPTURE(format);
        check_wedge(read("a.ply", PlyWriter(format).wedge(true)));
    }
    CHECK_THAT(error("a.ply", replaced(PlyWriter("ascii").wedge(true), "5.000000 3.000000 ", "5.000000 6.000000 ")),
               Contains("a.ply:26: strip 1 (counted from 0) names vertex 6, which does not exist"));
    CHECK_THAT(error("a.ply", replaced(PlyWriter("ascii").wedge(true), "-1.000000 ", "-2.000000 ")),
               Contains("a.ply:25: strip 0 (counted from 0) names vertex -2, which does not exist"));
}

TEST_CASE("A PLY header that makes no sense is refused at its line", "[mesh_readers]") {
    std::string const good = PlyWriter("ascii").wedge(false);
    auto const with = [&](std::string const& from, std::string const& to) {
        return error("a.ply", replaced(good, from, to));
    };
    CHECK_THAT(with("format ascii", "format asci"),
               Contains("a.ply:2: format asci, expected ascii, binary_little_endian"));
    CHECK_THAT(with("element face", "elment face"), Contains("a.ply:12: elment: is no statement of a header"));
    CHECK_THAT(with("element face 5", "element face -5"),
               Contains("a.ply:12: element face of -5 rows, expected a count"));
    CHECK_THAT(with("property float64 z", "property float64 w"),
               Contains("a.ply:7: element vertex has not one property"));
    CHECK_THAT(with("vertex_index", "corners"), Contains("a.ply:12: element face has no list vertex_indices"));
    CHECK_THAT(with("format ascii 1.0\n", ""), Contains("a.ply: has no line format in its header"));
    CHECK_THAT(with("format ascii 1.0", "format ascii 2.0"), Contains("a.ply:2: format of version 2.0, expected 1.0"));
    CHECK_THAT(with("format ascii 1.0\n", "format ascii 1.0\nformat ascii 1.0\n"),
               Contains("a.ply:3: a second line format, expected one"));
    CHECK_THAT(with("3.000000 0.000000 2", "3.5 0.000000 2"), Contains("length 3.5, expected a count"));
    CHECK_THAT(with("vertex_index\n", "vertex_index\nproperty list uchar int vertex_indices\n"),
               Contains("a.ply:12: element face has the lists vertex_index and vertex_indices, expected one of them"));
}

TEST_CASE("STL is read as text and binary, whatever its header says", "[mesh_readers]") {
    std::string const loop = "outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n";
    std::string const text = "solid facet normal outer loop vertex\n# x\ncolor 1 2 3\nfacet normal nan nan nan\n" +
                             loop + "endfacet\nendsolid facet\n";
    CHECK(read("a.stl", text).faces.size() == 1);
    CHECK(read("a.stl", text + text).faces.size() == 2);
    CHECK(read("a.stl", "\xEF\xBB\xBF" + text).faces.size() == 1);
    CHECK(read("a.stl", replaced(text, "\n", "\r\n")).faces.size() == 1);
    CHECK(read("a.stl", replaced(replaced(text, "end", "end "), "solid", "SOLID")).faces.size() == 1);
    CHECK(read("a.stl", replaced(text, "endloop", "vertex -1 -1 0\nendloop")).faces.size() == 2);
    CHECK_THAT(error("a.stl", text.substr(0, text.find("vertex 0 1 0"))), Contains("a.stl:8: the file ends early"));
    CHECK_THAT(error("a.stl", replaced(text, "vertex 0 1 0\n", "")), Contains("a.stl:8: endloop after 2 vertices"));
    CHECK_THAT(error("a.stl", replaced(text, "1 0 0", "1 0")),
               Contains("a.stl:7: vertex 1 (counted from 0) has nothing"));

    std::string binary = "solid made by a CAD system";
    binary.resize(80, ' ');
    binary += std::string{"\1\0\0\0", 4} + std::string(12, '\xFF');
    for (float const number : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F}) {
        char bytes[4];
        std::memcpy(bytes, &number, 4);
        binary.append(bytes, 4);
    }
    binary += "ab";
    CHECK(read("a.stl", binary).faces.size() == 1);
    CHECK_THAT(error("a.stl", binary.substr(0, binary.size() - 1)), Contains("(it ends early)"));
    CHECK_THAT(error("a.stl", binary + std::string(50, '\0')),
               Contains("has the bytes of 2 triangles, expected 1 as its header says"));
}

TEST_CASE("OFF is read with colours, normals and comments, and with counts behind its keyword", "[mesh_readers]") {
    std::string const vertices = "0 0 0\n2 0 0\n0 1 0\n0 0 3\n2 0 3\n0 1 3\n";
    std::string const faces = "3 0 2 1\n3 3 4 5\n4 0 1 4 3\n4 1 2 5 4\n4 2 0 3 5\n";
    std::string const colours = replaced(faces, "\n", " 0.1 0.2 0.3\n");
    for (std::string const start : {"OFF\n6 5 0\n", "OFF 6 5 9\n", "OFF6 5 9\n", "OFF # x\n#\n 6 5\n", "6 5 9\n",
                                    "OFF\n6 5\n9\n", "OFF\n6\n5\n#\n9 # edges\n", "OFF 6\n5 9\n"}) {
        CAPTURE(start);
        check_wedge(read("a.off", start + vertices + faces));
        check_wedge(read("a.off", start + vertices + colours));
    }
    check_wedge(read("a.off", "COFF\n6 5 0\n" + replaced(vertices, "\n", " 255 0 0 255\n") + faces + "2 0 1\n"));
    check_wedge(read("a.off", "STCNOFF\n6 5 0\n" + replaced(vertices, "\n", " 0 0 1 255 0 0 255 0 0\n") + faces));
    CHECK_THAT(error("a.off", "OFF\n6 6 0\n" + vertices + faces), Contains("a.off:14: the file ends early"));
    CHECK_THAT(error("a.off", "OFF\n6 x 0\n"), Contains("a.off:2: x as the number of faces, expected a count"));
}

TEST_CASE("A triangle begins with the corner that its face begins with, whatever other faces there are",
          "[mesh_readers]") {
    std::string const vertices = "OFF\n7 3 0\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n9 9 9\n";
    Mesh const mesh = read("a.off", vertices + "4 1 4 3 0\n3 1 2 5\n3 1 5 4\n");
    auto const corner = [&](std::size_t face) { return mesh.vertices[mesh.faces[face][0]]; };
    REQUIRE(mesh.faces.size() == 4);
    for (std::size_t face = 0; face < 4; ++face)
        CHECK(corner(face) == Eigen::Vector3d(1, 0, 0));
}

}  // namespace mesh_readers_test
