#include "dataflow/tools/report/html/html_report.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <utility>

#include "dataflow/base/program_name.hpp"
#include "dataflow/tools/report/latencies.hpp"
#include "faster/dataflow_names.hpp"
#include "support/example_run.hpp"
#include "support/idle_run.hpp"
#include "support/raster_machine.hpp"
#include "support/report_page.hpp"
#include "support/unpacked_timeline.hpp"

namespace dataflow::report::html_report_test {

using Json = nlohmann::ordered_json;
using faster::test::example_keys;
using faster::test::example_run;
using faster::test::hostile_text;
using faster::test::json_element;
using faster::test::packed_example_timeline;
using faster::test::unpacked;

std::string example_page() {
    return html_report({"example.yaml",
                        example_run(),
                        example_keys(),
                        {packed_example_timeline(1, 3, 450001)},
                        {{"Sample 0", "not really a PNG"}}});
}

std::size_t count_of(std::string const& part, std::string const& text) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
        ++count;
    return count;
}

TEST_CASE("The page holds the figures of the run as JSON", "[html]") {
    RunStatistics const run = example_run();
    Json const data = json_element(example_page(), "data");
    CHECK(data["format"] == "faster-report");
    CHECK(data["headline"]["total_cycles"] == run.total_cycles);
    CHECK(data["headline"]["milliseconds"] == 5.0);
    CHECK(data["headline"]["samples"] == 5);
    CHECK(data["headline"]["cores"] == 2);
    CHECK(data["bound_by"][0].get<std::string>().rfind("Bound by ", 0) == 0);
    CHECK(data["cycle_classes"].size() == cycle_class_count - 1);  // memory is ideal
    REQUIRE(data["modules"].size() == modules_of(run.machine).size());
    CHECK(data["modules"][2]["module"] == "rasterizer");
    CHECK(data["modules"][2]["cycles"][0] == 2 * 160000);             // of both cores
    for (std::size_t c = 0; c < data["cycle_classes"].size(); ++c) {  // one for each class
        std::size_t const of = run.machine.process("rasterizer");
        auto const is_named = [&](char const* name) { return data["cycle_classes"][c] == name; };
        auto const name = std::find_if(cycle_class_names.begin(), cycle_class_names.end(), is_named);
        REQUIRE(name != cycle_class_names.end());
        auto const number = static_cast<std::size_t>(name - cycle_class_names.begin());
        CHECK(data["modules"][2]["cycles"][c] == process_sum(run, of).cycles[number]);
    }
    CHECK(data["modules"][2]["cycles"].size() == data["cycle_classes"].size());
    CHECK(data["fifos"].size() == 2 * fifos_of(run.machine).size());
    CHECK(data["fifos"][3]["fifo"] == "vertex");
    CHECK(data["fifos"][3]["writes"] == 4000);
    CHECK(data["loops"].size() == 2 * loops_of(run.machine).size());
    CHECK(data["latency"]["min"] == 345000);
    CHECK(data["latency"]["max"] == 349000);
    CHECK(data["pictures"][0] == Json{{"title", "Sample 0"}, {"png", "bm90IHJlYWxseSBhIFBORw=="}});
}

TEST_CASE("The stalls in the page name FIFO, reason and partner, and add up to those of the modules", "[html]") {
    RunStatistics const run = example_run();
    Json const data = json_element(example_page(), "data");
    Cycles sum = 0, expected = 0;
    for (Json const& row : data["stalls"])
        sum += row["cycles"].get<Cycles>();
    for (std::size_t i = 0; i < run.machine.processes.size(); ++i) {
        ProcessStatistics const process = process_sum(run, i);
        expected +=
            process[CycleClass::empty_stall] + process[CycleClass::full_stall] + process[CycleClass::port_conflict];
    }
    CHECK(sum == expected);
    auto const is_sought = [](Json const& row) { return row["module"] == "rasterizer" && row["item"] == "edge_token"; };
    auto const row = std::find_if(data["stalls"].begin(), data["stalls"].end(), is_sought);
    REQUIRE(row != data["stalls"].end());
    CHECK((*row)["kind"] == "full_stall");
    CHECK((*row)["waits_for"] == "edge_map_builder");
}

TEST_CASE("A timeline in the page has named bars and occupancies", "[html]") {
    Json const timelines = json_element(example_page(), "data")["timelines"];
    REQUIRE(timelines.size() == 1);
    CHECK(timelines[0]["core"] == 1);
    CHECK(timelines[0]["sample"] == 3);
    CHECK(timelines[0]["begin"] == 450001);
    CHECK(timelines[0]["is"] == Json::array());
    Json const timeline = unpacked(timelines[0]["packed"]);
    CHECK(timeline["items"][0] == Json::array({"vertex_transform", "loop", "vertex"}));
    Json const& coarse = timeline["levels"][0];
    auto const first = [&coarse](char const* column) { return coarse[column][0].get<Cycles>(); };
    CHECK(first("item") == 0);
    CHECK(first("begin") == 0);
    CHECK(first("length") == 220000);
    CHECK(first("gaps") == 0);
    CHECK(first("iterations") == 110000);
    CHECK(first("spans") == 1);
    CHECK(timeline["occupancy"]["vertex"]["mean"].size() == 120);
    CHECK_FALSE(timeline["occupancy"].contains("result"));
}

TEST_CASE("The finest bars of a timeline in the page are all its spans, or as many as are allowed", "[html]") {
    SampleTimeline const timeline = faster::test::example_timeline(1, 3, 450001);
    Machine const machine = example_run().machine;
    Json const all = unpacked(packed_timeline(machine, timeline, 100'000).packed)["levels"];
    CHECK(all.front()["resolution"] == 345000 / 2000);
    CHECK(all.back()["resolution"] == 0);
    Cycles begin = timeline.begin, cycles = 0, iterations = 0, spans = 0;
    for (std::size_t i = 0; i < all.back()["item"].size(); ++i) {
        begin += all.back()["begin"][i].get<Cycles>();
        cycles += all.back()["length"][i].get<Cycles>() - all.back()["gaps"][i].get<Cycles>();
        iterations += all.back()["iterations"][i].get<Cycles>();
        spans += all.back()["spans"][i].get<Cycles>();
    }
    CHECK(begin == timeline.spans.back().begin);
    CHECK(spans == timeline.spans.size());
    for (TimelineSpan const& span : timeline.spans) {
        bool const is_loop = span.kind == TimelineSpan::Kind::loop;
        cycles -= is_loop ? span.end - span.begin : span.count;
        iterations -= is_loop ? span.count : 0;
    }
    CHECK(cycles == 0);
    CHECK(iterations == 0);
    Json const few = unpacked(packed_timeline(machine, timeline, 10).packed)["levels"];
    REQUIRE(few.size() == 1);  // never coarser than a screen
    CHECK(few[0] == all[0]);
}

TEST_CASE("The page names the samples that stand for others", "[html]") {
    RunStatistics run = example_run();
    for (SampleStatistics& sample : run.samples)
        sample.end_cycle = sample.start_cycle + 100 + (sample.sample == 3 ? 1 : 0);
    auto const standouts = standout_samples(run);
    REQUIRE(standouts.size() == 3);
    CHECK((standouts[0].is == std::string("median") && standouts[0].sample->sample == 2));
    CHECK((standouts[1].is == std::string("slowest") && standouts[1].sample->sample == 3));
    CHECK((standouts[2].is == std::string("fastest") && standouts[2].sample->sample == 0));
    Json const data = json_element(html_report({"name", run, {}, {packed_example_timeline(1, 3, 450001)}, {}}), "data");
    CHECK(data["timelines"][0]["is"] == Json::array({"slowest"}));
    run.samples.resize(1);
    CHECK(standout_samples(run)[1].sample->sample == 0);
    run.samples.clear();
    CHECK(standout_samples(run).empty());
}

TEST_CASE("The page has the memories of a core", "[html]") {
    RunStatistics const run = example_run();
    Json const area = json_element(html_report({"name", run, {}, {}, {}}), "data")["area"];
    CHECK(area["memories"].size() == brams_of(run.machine).size());
    CHECK(area["memories"][0]["ramb36"] == ramb36_count(run.machine.memories[brams_of(run.machine)[0]].shape));
}

TEST_CASE("The configuration in the page says what differs from the defaults", "[html]") {
    Json const rows = json_element(example_page(), "data")["configuration"];
    CHECK(rows.size() == example_keys().size());
    for (Json const& row : rows) {
        CAPTURE(row.dump());
        bool const is_changed = row["key"] == "accelerator.raster_cores" || row["key"] == "workload.trace";
        CHECK(row["default"] == !is_changed);
        if (row["key"] == "workload.trace")
            CHECK(row["value"] == hostile_text);
    }
}

TEST_CASE("Hostile names do not leave their element", "[html]") {
    std::string const page = html_report({hostile_text, example_run(), example_keys(), {}, {{hostile_text, "png"}}});
    std::string const harmless = html_report({"name", example_run(), {}, {}, {}});
    for (std::string const part : {"<script", "</script", "<img", "<!--", "<title"}) {
        CAPTURE(part);
        CHECK(count_of(part, page) == count_of(part, harmless));
    }
    CHECK(json_element(page, "data")["pictures"][0]["title"] == hostile_text);
}

TEST_CASE("A title that looks like a place in the template stays a title", "[html]") {
    std::string const page = html_report({"@data@ @title@", example_run(), {}, {}, {}});
    CHECK(count_of("<h1>@data@ @title@</h1>", page) == 1);
    CHECK(json_element(page, "data")["format"] == "faster-report");
}

TEST_CASE("A page is headed by its title and the name of the program that made it", "[html]") {
    std::string const name = std::exchange(program_name(), "memory <1>");
    std::string const page = example_page();
    program_name() = name;
    CHECK(count_of("<title>example.yaml - memory &lt;1&gt;</title>", page) == 1);
    CHECK(count_of("<p class=\"tool\">memory &lt;1&gt;</p>\n  <h1>example.yaml</h1>", page) == 1);
}

TEST_CASE("Bytes that are no UTF-8 do not break the page", "[html]") {
    std::string const page = html_report({"\xff", example_run(), {}, {}, {{"\xff\xfe", "png"}}});
    CHECK(json_element(page, "data")["pictures"].size() == 1);
}

TEST_CASE("A run without samples, timelines and pictures has a page, too", "[html]") {
    RunStatistics const empty = faster::testing::idle_run(faster::testing::raster_machine({}), 0);
    Json const data = json_element(html_report({"empty", empty, {}, {}, {}}), "data");
    CHECK(data["headline"]["total_cycles"] == 0);
    CHECK(data["latency"].is_null());
    CHECK(data["critical_path"].is_null());
    for (char const* const list :
         {"sensitivities", "bound_by", "stalls", "fifos", "loops", "timelines", "pictures", "configuration"}) {
        CAPTURE(list);
        CHECK(data[list] == Json::array());
    }
}

TEST_CASE("The page is complete in itself", "[html]") {
    std::string const page = html_report({"name", example_run(), {}, {}, {}});
    CHECK(count_of("default-src 'none'", page) == 1);  // the browser would refuse to load anything
    for (std::string const load : {" src=", "<link", "@import", "url(", "fetch(", "XMLHttpRequest", "import("}) {
        CAPTURE(load);
        CHECK(count_of(load, page) == 0);
    }
    CHECK(count_of("@style@", page) + count_of("@chart_js@", page) + count_of("@scripts@", page) == 0);
    CHECK(count_of("Chart.js v3", page) == 1);  // with its licence
}

}  // namespace dataflow::report::html_report_test
