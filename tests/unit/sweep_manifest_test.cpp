#include <catch2/catch.hpp>

#include "dataflow/tools/sweeps/manifest.hpp"
#include "faster/dataflow_names.hpp"
#include "support/input_error_text.hpp"

namespace sweep_manifest_test {

using namespace faster::test;
using Catch::Matchers::Contains;
using dataflow::sweeps::Manifest;
using dataflow::sweeps::manifest_from_text;
using dataflow::sweeps::to_text;
using dataflow::sweeps::why_no_part_of;

Manifest const small{"small.yaml", "1.0", {"a.b", "design"}, {{"01", {"1", "x, \"y\""}}, {"02", {"2", "z"}}}};

TEST_CASE("A manifest is read as it was written", "[sweeps]") {
    Manifest const read = manifest_from_text(to_text(small), "sweep.json");
    CHECK(to_text(read) == to_text(small));
    CHECK(read.points[0].values == small.points[0].values);
    CHECK(read.name(1) == "point 1 (a.b=2 design=z)");
}

TEST_CASE("A sweep is part of one with more points, in any order", "[sweeps]") {
    Manifest larger = small;
    larger.points = {small.points[1], {"03", {"3", "z"}}, small.points[0]};
    CHECK(why_no_part_of(small, larger).empty());
    CHECK_THAT(why_no_part_of(larger, small),
               Contains("1 of its 3 points are not in small.yaml, the first is point 1 (a.b=3 design=z)"));
}

TEST_CASE("Results of another faster-sim are not taken for ours", "[sweeps]") {
    Manifest other = small;
    other.version = "1.1";
    CHECK_THAT(why_no_part_of(small, other), Contains("it is of faster-sim 1.0, this is 1.1"));
}

TEST_CASE("What is no manifest is refused", "[sweeps]") {
    auto const error = [](std::string const& text) {
        return input_error_text([&] { manifest_from_text(text, "out/sweep.json"); });
    };
    CHECK_THAT(error(""), Contains("out/sweep.json: is damaged"));
    CHECK_THAT(error(to_text(small).substr(0, 40)), Contains("is damaged"));
    std::string text = to_text(small);
    text.replace(text.find("\"version\":1"), 11, "\"version\":2");
    CHECK_THAT(error(text), Contains("of another format or version"));
    text = to_text(small);
    text.replace(text.find("[\"2\",\"z\"]"), 9, "[\"2\"]");
    CHECK_THAT(error(text), Contains("another number of values"));
}

}  // namespace sweep_manifest_test
