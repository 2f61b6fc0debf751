#include <catch2/catch.hpp>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/on_terminal.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace show_test {

using namespace faster::test;
namespace fs = std::filesystem;
using Words = std::vector<std::string>;

/// A folder with "out", the results of a stored trace with pictures of its first samples.
class ShownRun {
  public:
    explicit ShownRun(std::string const& trace, int images = 99) {
        fs::path const source = FASTER_SOURCE_DIR;
        require_done_with_warnings(
            run_command(FASTER_SIM_BINARY,
                        {"run", source / "configs/faster_zcu102.yaml", "--trace", source / "traces" / trace, "--set",
                         "accelerator.raster_cores=2", "--out", "out", "--images", std::to_string(images)},
                        folder_.path()));
    }

    CommandResult show(Words arguments) const {
        arguments.insert(arguments.begin(), "show");
        return run_command(FASTER_SIM_BINARY, arguments, folder_.path());
    }
    std::string shown(Words const& arguments) const {
        CommandResult const result = show(arguments);
        require_done(result);
        return result.out;
    }
    fs::path operator/(std::string const& name) const { return folder_ / name; }
    void write(std::string const& name, std::string const& content) const { folder_.write(name, content); }
    std::string on_terminal(Words const& environment) const {
        return output_on_terminal(FASTER_SIM_BINARY, {"show", folder_ / "out"}, environment);
    }

  private:
    TempFolder folder_;
};

cv::Size size_of(fs::path const& picture) { return cv::imread(picture.string(), cv::IMREAD_UNCHANGED).size(); }

std::string const contour_legend = "edge map (#) over object map (.)\n";
std::string const figures_of_one_triangle =
    "sample 0 on core 0: latency 4158 cycles, 13 inliers, 4 of 11 edge pixels are edge inliers\n";
std::string const with_24_bits = "COLORTERM=truecolor";
Words const plain_lines_of_one_triangle{"##########", "..........##", "........##", "......##", "....##", "..##", "##"};

std::string joined(Words const& lines) {
    std::string text;
    for (std::string const& line : lines)
        text += line + "\n";
    return text;
}

TEST_CASE("show prints a sample's figures and its picture in letters") {
    ShownRun const run("one_triangle");
    // The running example of docs/modules: 15 pixels, edges above and on the right, every pixel two letters wide.
    CHECK(run.shown({"out"}) == figures_of_one_triangle + contour_legend + joined(plain_lines_of_one_triangle));
    CHECK(run.shown({"out", "--sample", "0", "--width", "10"}) ==
          figures_of_one_triangle + contour_legend + "######\n...##\n.##\n#\n");
    CHECK(run.shown({"out", "--depth"}) == figures_of_one_triangle +
                                               "depth from 0.992 m (@) to 1.008 m (.)\n"
                                               "++++++++++\n++++++++\n++++++\n++++\n++\n");
}

TEST_CASE("show prints any sample of which there are pictures, no wider than asked for") {
    ShownRun const run("edge_heavy");
    std::string const last = run.shown({"out", "--sample", "4"});
    CHECK(lines_of(last).front() ==
          "sample 4 on core 1: latency 8318 cycles, 28 inliers, 6 of 51 edge pixels are edge inliers");
    for (int const width : {10, 17, 40})
        for (std::string const& sample : Words{"0", "1", "2", "3"}) {
            Words const lines = lines_of(run.shown({"out", "--sample", sample, "--width", std::to_string(width)}));
            REQUIRE(lines.size() > 3);
            CHECK(lines.size() <= static_cast<std::size_t>(2 + (width + 1) / 2));
            for (std::size_t i = 2; i < lines.size(); ++i)
                CHECK(lines[i].size() <= static_cast<std::size_t>(width));
        }
}

TEST_CASE("show says so when nothing is drawn") {
    ShownRun const run("empty");
    std::string const expected =
        "sample 1 on core 0: latency 8213 cycles, 0 inliers, 0 of 0 edge pixels are edge inliers\nnothing is drawn in "
        "its "
        "window\n";
    CHECK(run.shown({"out", "--sample", "1"}) == expected);
    CHECK(run.shown({"out", "--sample", "1", "--depth"}) == expected);
}

TEST_CASE("show takes colours and half-blocks on a terminal that has them, and letters where it has not") {
    ShownRun const run("one_triangle");
    std::string const plain = figures_of_one_triangle + contour_legend + joined(plain_lines_of_one_triangle);
    std::string const red = "38;2;215;25;28;48;2;215;25;28m", green = "38;2;150;215;140;48;2;150;215;140m";

    std::string const coloured = run.on_terminal({with_24_bits, "NO_COLOR="});
    CHECK(lines_of(coloured).size() == 2 + plain_lines_of_one_triangle.size());
    CHECK_THAT(coloured, Catch::StartsWith(figures_of_one_triangle + "edge map (red) over object map (green)\n\033[" +
                                           red + "▀▀▀▀▀▀▀▀▀▀\033[0m"));
    CHECK_THAT(coloured, Catch::Contains("\033[" + green + "▀▀\033[" + red + "▀▀\033[0m"));
    CHECK_THAT(coloured, !Catch::Contains("#"));

    CHECK(run.on_terminal({with_24_bits, "NO_COLOR=1"}) == plain);
    CHECK(run.on_terminal({"COLORTERM=", "NO_COLOR=", "TERM=vt100"}) == plain);
}

TEST_CASE("show refuses a folder without pictures in one line that says how to make them") {
    ShownRun const run("one_triangle");
    check_bad_input(run.show({"nowhere"}), {"nowhere: no such folder, expected the results of a run",
                                            "faster-sim run CONFIG --out nowhere --images 1"});
    check_bad_input(run.show({"out/samples.csv"}), {"out/samples.csv: is a file, expected the results of a run"});

    fs::remove(run / "out/images/sample_0000_edges.png");
    check_bad_input(run.show({"out"}), {"out/images: no picture in it, expected sample_NNNN_{edges,object,depth}.png",
                                        "faster-sim run CONFIG --out out --images 1"});
    fs::remove_all(run / "out/images");
    check_bad_input(run.show({"out"}), {"out/images: no such folder, expected pictures of a run",
                                        "faster-sim run CONFIG --out out --images 1"});
    run.write("out/images", "");
    check_bad_input(run.show({"out"}), {"out/images: is a file, expected pictures of a run"});
}

TEST_CASE("show refuses a sample without pictures in one line that says which there are") {
    ShownRun const run("edge_heavy", 2);
    check_bad_input(run.show({"out", "--sample", "3"}), {"--sample 3: no picture of it in out/images, expected 0..1",
                                                         "faster-sim run CONFIG --out out --images 4"});
    check_bad_input(run.show({"out", "--sample", "5"}), {"--sample 5: no row of it in out/samples.csv, expected 0..4",
                                                         "faster-sim run CONFIG --out out --images 5"});
}

TEST_CASE("show refuses damaged results in one line") {
    ShownRun const run("one_triangle");
    std::string const depth = "out/images/sample_0000_depth.png", object = "out/images/sample_0000_object.png";
    fs::copy_file(run / object, run / depth, fs::copy_options::overwrite_existing);
    check_bad_input(run.show({"out"}), {depth + ": is an 8-bit greyscale PNG, expected a 16-bit greyscale PNG"});
    cv::imwrite(run / depth, cv::Mat(4, 5, CV_16UC1, cv::Scalar(512)));
    check_bad_input(run.show({"out"}), {depth + ": has 5 x 4 pixels, expected 32 x 32 (the size of the edge map)"});
    fs::remove(run / depth);
    check_bad_input(run.show({"out"}), {depth + ": no such file", "--images 1"});
}

TEST_CASE("show refuses tables that are no run's in one line") {
    ShownRun const run("one_triangle");
    run.write("out/summary.json", "{}");
    check_bad_input(run.show({"out", "--depth"}), {"out/summary.json", "accelerator.fraction_bits.depth_buffer"});
    run.write("out/samples.csv", "sample,core\n0,0\n");
    check_bad_input(run.show({"out"}), {"out/samples.csv:1", "latency_cycles"});
    fs::remove(run / "out/samples.csv");
    check_bad_input(run.show({"out"}), {"out/samples.csv: no such file"});
}

TEST_CASE("show refuses bad usage in one line") {
    ShownRun const run("one_triangle");
    check_bad_input(run.show({}), {"folder"});
    check_bad_input(run.show({"out", "--sample", "-1"}), {"--sample"});
    check_bad_input(run.show({"out", "--sample", "one"}), {"--sample"});
    check_bad_input(run.show({"out", "--width", "3"}), {"--width"});
    check_bad_input(run.show({"out", "--images", "3"}), {"--images"});
}

TEST_CASE("Pictures for people are about 600 pixels high, and the contact sheet stays within 4000") {
    ShownRun const run("edge_heavy");
    CHECK(size_of(run / "out/images/sample_0004_overlay.png") == cv::Size(576, 576));  // 18 x 32
    cv::Size const depth_map = size_of(run / "out/images/sample_0004_depth_map.png");
    CHECK(depth_map.height == 576);
    CHECK(depth_map.width > 576);
    cv::Size const sheet = size_of(run / "out/images/contact_sheet.png");
    CHECK((sheet.width > 800 && sheet.width <= 4000));  // two samples of two pictures side by side
    CHECK((sheet.height > 600 && sheet.height <= 4000));
}

}  // namespace show_test
