#include "dataflow/tools/sweeps/sweep_file.hpp"

#include <catch2/catch.hpp>
#include <set>

#include "dataflow/run/config/keys.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"
#include "support/temp_folder.hpp"

namespace sweep_file_test {

using namespace faster;
using namespace faster::test;
using Catch::Matchers::Contains;
using sweeps::Sweep;
using Values = std::vector<std::string>;

std::string const start = "format: faster-sweep\nversion: 1\n";

class Folder {
  public:
    Sweep sweep(std::string const& text) const {
        return sweeps::read_sweep_file(folder_.write("sweep.yaml", start + text));
    }
    /// Of dimensions, written as YAML's list in one line.
    std::vector<Values> points(std::string const& dimensions) const {
        Sweep const read = sweep("dimensions: [" + dimensions + "]\n");
        std::vector<Values> all;
        for (std::size_t i = 0; i < read.points(); ++i)
            all.push_back(read.values(i));
        return all;
    }
    std::string error(std::string const& text) const {
        return input_error_text([&] { sweep(text); });
    }
    TempFolder const& folder() const { return folder_; }

  private:
    TempFolder folder_;
};

std::string item(std::string const& text) { return "dimensions:\n  - " + text + "\n"; }

TEST_CASE("A sweep is every combination of its dimensions, the last one quickest", "[sweeps]") {
    Folder const folder;
    CHECK(folder.points("{key: accelerator.raster_cores, values: [1, 5]}, "
                        "{key: accelerator.fifos.vertex.kind, values: [auto, memory]}") ==
          std::vector<Values>{{"1", "auto"}, {"1", "memory"}, {"5", "auto"}, {"5", "memory"}});
}

TEST_CASE("A range goes up to its end in steps", "[sweeps]") {
    Folder const folder;
    CHECK(folder.points("{key: accelerator.raster_cores, range: [2, 9], step: 3}") ==
          std::vector<Values>{{"2"}, {"5"}, {"8"}});
    CHECK(folder.points("{key: accelerator.raster_cores, range: [2, 4]}") == std::vector<Values>{{"2"}, {"3"}, {"4"}});
    CHECK(folder.points("{key: workload.samples.translation_sigma_m, range: [0.1, 0.3], step: 0.1}") ==
          std::vector<Values>{{"0.1"}, {"0.2"}, {"0.3"}});
}

TEST_CASE("Zipped lists go together", "[sweeps]") {
    Folder const folder;
    CHECK(folder.points("{zip: {accelerator.loops.rasterizer.scan.depth: [8, 10], "
                        "accelerator.fifos.command.write_latency: [7, 9]}}") ==
          std::vector<Values>{{"8", "7"}, {"10", "9"}});
}

TEST_CASE("Seeds are the same for all keys of a dimension", "[sweeps]") {
    Folder const folder;
    CHECK(folder.points("{seeds: [workload.samples.seed, workload.scene.seed], count: 2, first: 7}") ==
          std::vector<Values>{{"7", "7"}, {"8", "8"}});
}

TEST_CASE("Random points stay in their ranges, and a larger count only adds some", "[sweeps]") {
    Folder const folder;
    std::string const random =
        "{random: {accelerator.fifos.vertex.depth: {log_range: [2, 64]}, accelerator.raster_cores: {range: [3, 5]}, "
        "accelerator.clock_mhz: {range: [100, 300]}, accelerator.fifos.area.kind: {choices: [auto, memory]}}, seed: "
        "4, ";
    std::vector<Values> const few = folder.points(random + "count: 100}");
    std::vector<Values> const more = folder.points(random + "count: 300}");
    REQUIRE(few.size() == 100);
    REQUIRE(more.size() == 300);
    CHECK(std::equal(few.begin(), few.end(), more.begin()));
    std::set<std::string> cores, kinds;
    std::size_t shallow = 0;
    for (Values const& point : more) {
        int const depth = std::stoi(point[0]);
        CHECK((depth >= 2 && depth <= 64));
        if (depth < 12)  // about half of the octaves
            ++shallow;
        cores.insert(point[1]);
        CHECK((std::stod(point[2]) >= 100 && std::stod(point[2]) <= 300));
        kinds.insert(point[3]);
    }
    CHECK(cores == std::set<std::string>{"3", "4", "5"});
    CHECK(kinds == std::set<std::string>{"auto", "memory"});
    CHECK((shallow > 100 && shallow < 200));
}

TEST_CASE("A point is its base, overlays, settings and keys, in this order", "[sweeps]") {
    Folder const folder;
    folder.folder().write("base.yaml", "accelerator: {raster_cores: 7, window: 50, clock_mhz: 120}\n");
    folder.folder().write("a.yaml", "accelerator: {window: 60, fifos: {vertex: {depth: 9}}}\n");
    folder.folder().write("b.yaml", "{}\n");
    Sweep const sweep = folder.sweep(
        "base: base.yaml\nset: {accelerator.fifos.vertex.depth: 5}\n"
        "dimensions:\n  - {overlay: design, files: [a.yaml, b.yaml]}\n"
        "  - {key: accelerator.clock_mhz, values: [150]}\n");
    REQUIRE(sweep.points() == 2);
    AcceleratorConfig const first = accelerator_of(sweep.configuration(0).config);
    AcceleratorConfig const second = accelerator_of(sweep.configuration(1).config);
    CHECK(first.cores == 7);
    CHECK(first.window == 60);
    CHECK(second.window == 50);
    CHECK(first.fifo("vertex").depth == 5);
    CHECK(first.clock_mhz == 150);
    CHECK(sweep.values(0) == Values{"a.yaml", "150"});
}

TEST_CASE("A point that is no valid configuration is named", "[sweeps]") {
    Folder const folder;
    Sweep const sweep = folder.sweep(item("{key: accelerator.loops.rasterizer.scan.depth, values: [8, 4]}"));
    CHECK_NOTHROW(sweep.configuration(0));
    CHECK_THAT(
        input_error_text([&] { sweep.configuration(1); }),
        Contains("sweep.yaml: point 1 (accelerator.loops.rasterizer.scan.depth=4)") && Contains("write_latency"));
}

TEST_CASE("What is wrong with a sweep file is said with file, line, key and the nearest name", "[sweeps]") {
    Folder const folder;
    auto const check = [&](std::string const& text, std::vector<std::string> const& parts) {
        std::string const message = folder.error(text);
        for (std::string const& part : parts)
            CHECK_THAT(message, Contains(part));
        CHECK(message.find('\n') == std::string::npos);
    };
    check("dimension: []\n", {"sweep.yaml:3: dimension: unknown key", "did you mean dimensions?"});
    check("base: x.yaml\n", {"sweep.yaml:1: dimensions: missing"});
    check("dimensions: []\n", {"sweep.yaml:3: dimensions", "at least one dimension"});
    check("dimensions: [3]\n", {"sweep.yaml:3", "expected a map"});
    check("set: {accelerator.windw: 3}\n" + item("{key: accelerator.raster_cores, values: [1]}"),
          {"sweep.yaml:3", "did you mean accelerator.window?"});
    check(item("{key: accelerator.raster_cors, values: [1]}"),
          {"sweep.yaml:4", "did you mean accelerator.raster_cores"});
    check(item("{key: accelerator.raster_cores, values: [1, many]}"), {"sweep.yaml:4", "many", "expected an integer"});
    check(item("{key: accelerator.raster_cores, values: [1, 1]}"), {"sweep.yaml:4", "1 stands twice"});
    check(item("{key: accelerator.raster_cores, valus: [1]}"), {"valus: unknown key", "did you mean values?"});
    check(item("{key: accelerator.raster_cores}"), {"dimensions.values: missing"});
    check(item("{kye: accelerator.raster_cores}"), {"kye, expected one of", "did you mean key?"});
    check(item("{key: accelerator.raster_cores, range: [5, 2]}"), {"smaller first"});
    check(item("{key: accelerator.raster_cores, range: [1, 5], step: 0.5}"), {"step = 0.5", "whole number"});
    check(item("{key: accelerator.fifos.vertex.kind, range: [1, 5]}"), {"range is for numbers"});
    check(item("{key: accelerator.fifos, values: [1]}"), {"accelerator.fifos: is a section"});
    check(item("{overlay: accelerator.x, files: [a.yaml]}"), {"one word without points"});
    check(item("{overlay: status, files: [a.yaml]}"), {"expected another name"});
    check(item("{zip: {accelerator.raster_cores: [1, 2], accelerator.window: [9]}}"), {"1 values, expected 2"});
    check(item("{random: {accelerator.window: {rnge: [9, 20]}}, count: 3, seed: 1}"), {"did you mean range?"});
    check(item("{random: {accelerator.window: {range: [9, 20]}}, count: 3}"), {"dimensions.seed: missing"});
    check(item("{random: {workload.samples.count: {log_range: [0, 20]}}, count: 3, seed: 1}"), {"above 0"});
    check(item("{seeds: [accelerator.window], count: 3}"), {"accelerator.window: is no seed"});
    check(item("{key: accelerator.window, values: [50]}") + "  - {key: accelerator.window, values: [60]}\n",
          {"sweep.yaml:5: accelerator.window: stands twice"});
    check(item("{key: accelerator.window, range: [1, 1000]}") + "  - {seeds: [workload.samples.seed], count: 1000}\n",
          {"1000000 points, expected at most 100000"});
}

}  // namespace sweep_file_test
