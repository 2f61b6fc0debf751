#include "faster/workload/files/trace.hpp"

#include <catch2/catch.hpp>
#include <stdexcept>
#include <string>

#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace trace_test {

using namespace faster;
using files::read_trace;
using files::write_trace;
using test::content_of;
using test::entries_in;
using test::input_error_text;
using test::TempFolder;
namespace fs = std::filesystem;

/// Small, with every limit of the formats in it.
Stimulus small_stimulus() {
    Stimulus stimulus;
    stimulus.width = 6;
    stimulus.height = 4;
    stimulus.window = 8;
    stimulus.fraction = {3, 13, 28, 17, 8};
    stimulus.triangles = {{{{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}},
                          {{{-32768, 32767, 65535}, {32767, -32768, 0}, {-1, -2, 3}}}};
    stimulus.samples = {{2, 3, 0, 2}, {-2147483647 - 1, 2147483647, 1, 1}, {0, 0, 2, 0}};
    stimulus.observed_depth = Image<std::uint16_t>(4, 6, 300);
    stimulus.observed_depth.at(0, 5) = far_depth_code;
    stimulus.observed_depth.at(3, 0) = 0;
    stimulus.observed_edges = Image<std::uint8_t>(4, 6);
    stimulus.observed_edges.at(1, 2) = 1;
    return stimulus;
}

void check_same(Stimulus const& found, Stimulus const& expected) {
    CHECK(found.width == expected.width);
    CHECK(found.height == expected.height);
    CHECK(found.window == expected.window);
    CHECK(found.fraction == expected.fraction);
    CHECK(found.triangles == expected.triangles);
    CHECK(found.observed_depth == expected.observed_depth);
    CHECK(found.observed_edges == expected.observed_edges);
    REQUIRE(found.samples.size() == expected.samples.size());
    for (std::size_t index = 0; index < found.samples.size(); ++index) {
        CAPTURE(index);
        CHECK(found.samples[index].centre_row == expected.samples[index].centre_row);
        CHECK(found.samples[index].centre_col == expected.samples[index].centre_col);
        CHECK(found.samples[index].first_triangle == expected.samples[index].first_triangle);
        CHECK(found.samples[index].triangle_count == expected.samples[index].triangle_count);
    }
}

/// A valid trace on disk, for a test to spoil.
class Trace {
  public:
    Trace() { write_trace(small_stimulus(), path()); }

    fs::path path() const { return folder_ / "trace"; }
    fs::path operator/(std::string const& name) const { return path() / name; }
    void write(std::string const& name, std::string const& content) const { folder_.write("trace/" + name, content); }

    /// Replaces the first occurrence of `old_text` in one of its files.
    void edit(std::string const& name, std::string const& old_text, std::string const& new_text) const {
        std::string content = content_of(*this / name);
        auto const position = content.find(old_text);
        REQUIRE(position != std::string::npos);
        write(name, content.replace(position, old_text.size(), new_text));
    }

    /// What reading it complains about, without the path of the folder. Always one line.
    std::string error() const {
        std::string const text = input_error_text([&] { read_trace(path()); });
        CHECK(text.find('\n') == std::string::npos);
        auto const prefix = path().string() + "/";
        return text.rfind(prefix, 0) == 0 ? text.substr(prefix.size()) : text;
    }

  private:
    TempFolder folder_;
};

std::string edited_error(std::string const& name, std::string const& old_text, std::string const& new_text) {
    Trace const trace;
    trace.edit(name, old_text, new_text);
    return trace.error();
}

TEST_CASE("A trace comes back as it was written", "[trace]") {
    Trace const trace;
    check_same(read_trace(trace.path()), small_stimulus());
}

TEST_CASE("A trace without samples and triangles is valid", "[trace]") {
    TempFolder const folder;
    Stimulus stimulus = small_stimulus();
    stimulus.samples.clear();
    stimulus.triangles.clear();
    write_trace(stimulus, folder / "t");
    check_same(read_trace(folder / "t"), stimulus);
}

TEST_CASE("Depth is stored as codes, edges as 0 and 255", "[trace]") {
    Trace const trace;
    CHECK(files::read_png16(trace / "depth.png").at(0, 5) == 2047);
    CHECK(files::read_png8(trace / "edges.png").at(1, 2) == 255);
    CHECK(files::read_png8(trace / "edges.png").at(1, 3) == 0);
}

TEST_CASE("Columns are found by name, in any order and among others", "[trace]") {
    Trace const trace;
    trace.write("samples.csv",
                "triangle_count,note,centre_col,first_triangle,centre_row,sample\n"
                "2,any text,3,0,2,0\n"
                "1,,2147483647,1,-2147483648,1\n"
                "0,-,0,2,0,2\n");
    check_same(read_trace(trace.path()), small_stimulus());
}

TEST_CASE("CRLF, blanks around cells, empty lines at the end and a missing last newline are fine", "[trace]") {
    Trace const trace;
    trace.write("triangles.csv",
                "\xEF\xBB\xBFx0,y0,z0, x1,y1,z1,x2,y2,z2\r\n"
                "0,1,2, 3 ,4,5,6,7,8\r\n"
                "-32768,32767,65535,32767,-32768,0,-1,-2,3\r\n\r\n\n");
    trace.write("samples.csv",
                "sample,centre_row,centre_col,first_triangle,triangle_count\n"
                "0,2,3,0,2\n1,-2147483648,2147483647,1,1\n2,0,0,2,0");
    check_same(read_trace(trace.path()), small_stimulus());
}

TEST_CASE("The files of a trace may have other names", "[trace]") {
    Trace const trace;
    fs::rename(trace / "samples.csv", trace / "poses.csv");
    trace.edit("trace.yaml", "samples.csv", "poses.csv");
    check_same(read_trace(trace.path()), small_stimulus());
}

TEST_CASE("A trace that is not there is an input error", "[trace]") {
    CHECK(input_error_text([] { read_trace("/nowhere/t"); }) ==
          "/nowhere/t: no such folder, expected a stimulus trace");
    CHECK(input_error_text([] { read_trace("/dev/null"); }) ==
          "/dev/null: is a file, expected a folder: a stimulus trace");
    for (std::string const name : {"trace.yaml", "samples.csv", "triangles.csv", "depth.png", "edges.png"}) {
        Trace const trace;
        fs::remove(trace / name);
        CHECK(trace.error() == name + ": no such file, expected a readable file");
    }
}

TEST_CASE("Another format or version is an input error", "[trace]") {
    CHECK(edited_error("trace.yaml", "faster-trace", "slower-trace") ==
          "trace.yaml:1: format = slower-trace, expected faster-trace");
    CHECK(edited_error("trace.yaml", "version: 1", "version: 2") == "trace.yaml:2: version = 2, expected 1");
    CHECK(edited_error("trace.yaml", "version: 1", "version: 1.0") == "trace.yaml:2: version = 1.0, expected 1");
    CHECK(edited_error("trace.yaml", "version: 1", "version: \"1\"") == "trace.yaml:2: version = \"1\", expected 1");
}

TEST_CASE("An unknown key is an input error that names the nearest key", "[trace]") {
    CHECK(edited_error("trace.yaml", "window: 8", "windwo: 8") ==
          "trace.yaml:5: unknown key windwo, did you mean window?");
    CHECK(edited_error("trace.yaml", "  vertex_z: 13", "  vertex_z: 13\n  vertex_zz: 1") ==
          "trace.yaml:9: unknown key fraction.vertex_zz, did you mean vertex_z?");
    CHECK(edited_error("trace.yaml", "window: 8", "window: 8\nfoo: 1") ==
          "trace.yaml:6: unknown key foo, expected format, version, width, height, window, fraction, files");
}

TEST_CASE("A missing or repeated key is an input error", "[trace]") {
    CHECK_THAT(edited_error("trace.yaml", "height: 4\n", ""), Catch::Contains("no key height"));
    CHECK_THAT(edited_error("trace.yaml", "  depth_buffer: 8\n", ""), Catch::Contains("no key fraction.depth_buffer"));
    CHECK_THAT(edited_error("trace.yaml", "  edges: edges.png\n", ""), Catch::Contains("no key files.edges"));
    CHECK(edited_error("trace.yaml", "height: 4", "height: 4\nwidth: 5") ==
          "trace.yaml:5: key width stands twice, expected once");
}

TEST_CASE("Sizes and fraction bits have limits", "[trace]") {
    CHECK(edited_error("trace.yaml", "width: 6", "width: 0") ==
          "trace.yaml:3: width = 0, expected an integer in 1..4096");
    CHECK_THAT(edited_error("trace.yaml", "height: 4", "height: 4097"), Catch::Contains(":4: height = 4097, expected"));
    CHECK_THAT(edited_error("trace.yaml", "window: 8", "window: -8"), Catch::Contains(":5: window = -8, expected"));
    CHECK_THAT(edited_error("trace.yaml", "xy: 3", "xy: 16"),
               Catch::Contains("vertex_xy = 16, expected an integer in 0..15"));
    CHECK_THAT(edited_error("trace.yaml", "_z: 13", "_z: 17"),
               Catch::Contains("vertex_z = 17, expected an integer in 0..16"));
    CHECK_THAT(edited_error("trace.yaml", "nt_depth: 17", "nt_depth: 31"),
               Catch::Contains("fragment_depth = 31, expected an integer in 0..30"));
    CHECK_THAT(edited_error("trace.yaml", "_buffer: 8", "_buffer: 12"),
               Catch::Contains("depth_buffer = 12, expected an integer in 0..11"));
    CHECK_THAT(edited_error("trace.yaml", "cal: 28", "cal: 63"),
               Catch::Contains("area_reciprocal = 63, expected an integer in 0..62"));
}

TEST_CASE("Fraction bits that contradict each other are an input error", "[trace]") {
    CHECK(edited_error("trace.yaml", "cal: 28", "cal: 56") == "(no error)");  // 56 + 2 * 3 = 62
    CHECK(edited_error("trace.yaml", "cal: 28", "cal: 57") ==
          "trace.yaml:9: fraction.area_reciprocal = 57, expected at most 56 (62 - 2 * vertex_xy)");
}

TEST_CASE("A value of the wrong kind is an input error", "[trace]") {
    CHECK(edited_error("trace.yaml", "width: 6", "width: six") ==
          "trace.yaml:3: width = six, expected an integer in 1..4096");
    CHECK_THAT(edited_error("trace.yaml", "width: 6", "width: 6.0"), Catch::Contains("width = 6.0, expected"));
    CHECK_THAT(edited_error("trace.yaml", "width: 6", "width: [6]"), Catch::Contains("width = (no single value)"));
    CHECK_THAT(edited_error("trace.yaml", "width: 6", "width: 99999999999"), Catch::Contains("width = 99999999999"));
    CHECK_THAT(edited_error("trace.yaml", "depth: depth.png", "depth: {}"), Catch::Contains("files.depth is no text"));
    CHECK_THAT(edited_error("trace.yaml", "files:", "files: 3\nfraction2:"), Catch::Contains("trace.yaml:1"));
}

TEST_CASE("A trace.yaml that is no YAML mapping is an input error with its line", "[trace]") {
    CHECK_THAT(edited_error("trace.yaml", "width: 6", "width: [6"), Catch::StartsWith("trace.yaml:"));
    Trace const trace;
    trace.write("trace.yaml", "");
    CHECK_THAT(trace.error(), Catch::StartsWith("trace.yaml"));
    trace.write("trace.yaml", "- 1\n");
    CHECK_THAT(trace.error(), Catch::StartsWith("trace.yaml:1: the file is no mapping, expected the keys format, "));
}

TEST_CASE("A cell outside its column's format is an input error", "[trace]") {
    std::string const second_row = "-32768,32767,65535,32767,-32768,0,-1,-2,3";
    auto const row_error = [&](std::string const& row) { return edited_error("triangles.csv", second_row, row); };
    CHECK(row_error("-32769,0,0,0,0,0,0,0,0") ==
          "triangles.csv:3: column x0 = -32769, expected an integer in -32768..32767");
    CHECK(row_error("0,32768,0,0,0,0,0,0,0") ==
          "triangles.csv:3: column y0 = 32768, expected an integer in -32768..32767");
    CHECK(row_error("0,0,0,0,0,0,0,0,65536") == "triangles.csv:3: column z2 = 65536, expected an integer in 0..65535");
    CHECK(row_error("0,0,0,0,0,-1,0,0,0") == "triangles.csv:3: column z1 = -1, expected an integer in 0..65535");
    CHECK_THAT(edited_error("samples.csv", "2147483647", "2147483648"),
               Catch::Contains("samples.csv:3: column centre_col = 2147483648, expected"));
    CHECK_THAT(edited_error("samples.csv", "-2147483648", "-2147483649"),
               Catch::Contains("samples.csv:3: column centre_row = -2147483649, expected"));
}

TEST_CASE("A cell that is no integer is an input error", "[trace]") {
    for (std::string const cell : {"2.0", "2e0", "two", "0x2", "2 2", "+2", "99999999999999999999"}) {
        CHECK_THAT(edited_error("samples.csv", "0,2,3,0,2", "0," + cell + ",3,0,2"),
                   Catch::StartsWith("samples.csv:2: column centre_row = " + cell + ", expected an integer in "));
    }
    CHECK_THAT(edited_error("samples.csv", "0,2,3,0,2", "0,,3,0,2"),
               Catch::Contains("column centre_row = nothing, expected"));
}

TEST_CASE("A row with too few or too many cells is an input error", "[trace]") {
    CHECK(edited_error("samples.csv", "0,2,3,0,2", "0,2,3,0") == "samples.csv:2: 4 cells, expected 5 as in the header");
    CHECK(edited_error("samples.csv", "0,2,3,0,2", "0,2,3,0,2,9") ==
          "samples.csv:2: 6 cells, expected 5 as in the header");
    CHECK(edited_error("samples.csv", "\n0,2,3,0,2", "\n\n0,2,3,0,2") ==
          "samples.csv:2: 0 cells, expected 5 as in the header");
    CHECK(edited_error("triangles.csv", ",-2,3", "") == "triangles.csv:3: 7 cells, expected 9 as in the header");
}

TEST_CASE("A missing or repeated column is an input error", "[trace]") {
    CHECK(edited_error("samples.csv", "centre_col", "center_col") ==
          "samples.csv:1: no column centre_col in the header, expected "
          "sample,centre_row,centre_col,first_triangle,triangle_count");
    CHECK(edited_error("triangles.csv", "y1", "x0") ==
          "triangles.csv:1: column x0 stands twice in the header, expected once");
    Trace const trace;
    trace.write("triangles.csv", "");
    CHECK_THAT(trace.error(), Catch::StartsWith("triangles.csv:1: no column x0 in the header"));
}

TEST_CASE("Samples that are not numbered 0, 1, 2, ... are an input error", "[trace]") {
    CHECK(edited_error("samples.csv", "\n2,0,0", "\n3,0,0") ==
          "samples.csv:4: sample = 3, expected 2 (numbered from 0 without gaps)");
    CHECK(edited_error("samples.csv", "\n0,2,3", "\n1,2,3") ==
          "samples.csv:2: sample = 1, expected 0 (numbered from 0 without gaps)");
}

TEST_CASE("A sample whose triangles lie outside the file is an input error", "[trace]") {
    CHECK(edited_error("samples.csv", "0,2,3,0,2", "0,2,3,0,3") ==
          "samples.csv:2: first_triangle + triangle_count = 3, expected at most 2 (the triangles of the trace)");
    CHECK_THAT(edited_error("samples.csv", "2,0,0,2,0", "2,0,0,3,0"), Catch::Contains("= 3, expected at most 2"));
    CHECK_THAT(edited_error("samples.csv", "0,2,3,0,2", "0,2,3,4294967295,4294967295"),
               Catch::Contains("= 8589934590, expected at most 2"));
}

TEST_CASE("A depth code above far is an input error that names the pixel", "[trace]") {
    Trace const trace;
    Image<std::uint16_t> depth = small_stimulus().observed_depth;
    depth.at(2, 3) = 2048;
    files::write_png(trace / "depth.png", depth);
    CHECK(trace.error() == "depth.png: pixel at row 2, column 3 is 2048, expected at most 2047, far");
}

TEST_CASE("An edge value other than 0 and 255 is an input error that names the pixel", "[trace]") {
    Trace const trace;
    Image<std::uint8_t> edges(4, 6);
    edges.at(1, 5) = 1;
    files::write_png(trace / "edges.png", edges);
    CHECK(trace.error() == "edges.png: pixel at row 1, column 5 is 1, expected 0 or 255");
}

TEST_CASE("An image of the wrong size or type is an input error", "[trace]") {
    Trace const trace;
    files::write_png(trace / "edges.png", Image<std::uint8_t>(4, 7));
    CHECK(trace.error() == "edges.png: has 7 x 4 pixels, expected 6 x 4 (trace.yaml)");
    files::write_png(trace / "depth.png", Image<std::uint16_t>(6, 4));
    CHECK(trace.error() == "depth.png: has 4 x 6 pixels, expected 6 x 4 (trace.yaml)");
    files::write_png(trace / "depth.png", Image<std::uint8_t>(4, 6));
    CHECK(trace.error() == "depth.png: is an 8-bit greyscale PNG, expected a 16-bit greyscale PNG");
}

TEST_CASE("A trace replaces an older one, but nothing else", "[trace]") {
    Trace const trace;
    Stimulus smaller = small_stimulus();
    smaller.samples.resize(1);
    write_trace(smaller, trace.path());
    check_same(read_trace(trace.path()), smaller);

    TempFolder const folder;
    folder.write("thesis.tex", "mine");
    CHECK_THAT(input_error_text([&] { write_trace(smaller, folder.path()); }),
               Catch::EndsWith("holds other files, expected a new or empty folder or an older stimulus trace"));
    CHECK(entries_in(folder.path()) == 1);
}

TEST_CASE("Only a stimulus with explicit triangles and images of its size can be written", "[trace]") {
    TempFolder const folder;
    Stimulus posed = small_stimulus();
    posed.posed.poses.resize(3);
    CHECK_THROWS_AS(write_trace(posed, folder / "t"), std::logic_error);
    Stimulus lopsided = small_stimulus();
    lopsided.width = 7;
    CHECK_THROWS_AS(write_trace(lopsided, folder / "t"), std::logic_error);
    CHECK(entries_in(folder.path()) == 0);
}

}  // namespace trace_test
