#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "dataflow/tools/report/html/deadlock_html.hpp"
#include "dataflow/tools/report/html/html_report.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/workload/files/png_image.hpp"
#include "support/browser.hpp"
#include "support/example_run.hpp"
#include "support/idle_run.hpp"
#include "support/live_browser.hpp"
#include "support/raster_machine.hpp"
#include "support/report_page.hpp"
#include "support/temp_folder.hpp"

namespace html_report_browser_test {

using namespace faster;
using namespace faster::test;
using Json = nlohmann::ordered_json;
using Plain = nlohmann::json;
using Words = std::vector<std::string>;

std::string png_of(int side) { return files::colour_png(Image<Colour>(side, side, {60, 120, 180})); }

std::string example_page(std::string const& title) {
    return report::html_report({title,
                                example_run(),
                                example_keys(),
                                {packed_example_timeline(0, 0, 1), packed_example_timeline(1, 3, 450001)},
                                {{title, png_of(8)}}});
}

Json const& column(Json const& check, std::string const& table, std::string const& title) {
    Json const& columns = check["tables"][table];
    auto const found = std::find_if(columns.begin(), columns.end(),
                                    [&title](Json const& sorted) { return sorted["column"] == title; });
    REQUIRE(found != columns.end());
    return *found;
}

TEST_CASE("The browser draws every chart and section of the report without an error", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("report.html", example_page("example.yaml"));
    Json const check = self_check(folder, "report.html");
    CHECK(check["charts"] == 4 + 4);  // modules, critical path, timeline, latencies; four FIFOs with occupancies
    CHECK(check["pictures"] == 1);
    CHECK(check["sections"] ==
          Json::array({"summary", "graph", "modules", "critical-path", "sensitivities", "timeline", "fifos", "loops",
                       "memories", "resources", "latency", "pictures", "configuration"}));
    CHECK(check["keys"].size() == example_keys().size());
    CHECK(check["changed_keys"].size() == 2);
}

TEST_CASE("A click on the head of a column sorts numbers as numbers and names as names", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("report.html", example_page("example.yaml"));
    Json const check = self_check(folder, "report.html");
    Json const& writes = column(check, "FIFOs", "writes");  // 2 cores, 1000 more from row to row
    REQUIRE(writes["ascending"].size() == fifos_of(example_run().machine).size());
    CHECK(writes["ascending"].front() == "2,000");
    CHECK(writes["ascending"].back() == "28,000");
    CHECK(writes["descending"].front() == "28,000");
    Json const& loops = column(check, "Loops", "loop");
    CHECK(loops["ascending"].front() == "edge_map_builder.clear");
    CHECK(loops["descending"].front() == "vertex_transform.vertex");
    Json const& step = column(check, "Sensitivities", "one less");
    CHECK(step["ascending"] == Json::array({"-7,500", "deadlock"}));
    for (auto const& [table, columns] : check["tables"].items())
        for (Json const& sorted : columns) {
            CAPTURE(table, sorted["column"].get<std::string>());
            auto const as_set = [](Json const& texts) {
                return std::multiset<std::string>(texts.begin(), texts.end());
            };
            CHECK(as_set(sorted["ascending"]) == as_set(sorted["descending"]));
        }
}

TEST_CASE("The choices of core, sample and zoom show what they say", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("report.html", example_page("example.yaml"));
    Json const check = self_check(folder, "report.html");
    CHECK(check["cores"]["all, summed up"] == "sample_vertexshift register2122,0002,00001,800");
    CHECK(check["cores"]["core 1"] == "sample_vertexshift register2121,0001,0000900");
    CHECK(check["loops_of_cores"]["all, summed up"][0] == "20");  // entries
    CHECK(check["loops_of_cores"]["core 0"][0] == "10");
    std::string const held = " The page holds 2 of 5 samples; run --report-samples adds others, explore shows any.";
    CHECK(check["samples"]["0 (core 0): the fastest, 345,000 cycles"] ==
          "Sample 0 on core 0: 345,000 cycles, 1 to 345,000." + held);
    CHECK(check["samples"]["3 (core 1): 345,000 cycles"] ==
          "Sample 3 on core 1: 345,000 cycles, 450,001 to 795,000." + held);
    CHECK(check["zoomed"][0] == 345000);
    CHECK(check["zoomed"][1].get<double>() == Approx(345000 / std::exp2(12.75)));  // fifty cycles at least
    CHECK(check["zoomed"][2] == 345000);
}

/// An expression about the chart of the timeline.
std::string of_timeline(std::string const& expression) {
    return "(({data, scales}) => " + expression + ")(Chart.getChart(document.querySelector('#timeline-chart canvas')))";
}
std::string const bars = "data.datasets.flatMap((set) => set.data)";

TEST_CASE("The wheel brings finer bars where it zooms, and the keyboard another sample", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("report.html", example_page("example.yaml"));
    LiveBrowser browser(1280, 900);
    browser.open("file://" + (folder / "report.html").string());
    REQUIRE(browser.becomes_true("document.querySelector('#timeline-chart')?.dataset.shown == '0'"));
    CHECK(browser.value(of_timeline("scales.x.max - scales.x.min")) == 345000);
    CHECK(browser.value(of_timeline(bars + ".some(({span}) => span.spans > 1)")) == true);
    browser.wheel("#timeline-chart", -960);
    CHECK(browser.becomes_true(of_timeline("scales.x.max - scales.x.min == 345000 / 16")));
    CHECK(browser.value(of_timeline(bars + ".every(({span}) => span.spans == 1)")) == true);
    CHECK(browser.value(of_timeline(bars + ".every(({x}) => x[1] > scales.x.min && x[0] < scales.x.max)")) == true);

    browser.value("document.querySelector('#timeline-controls select').focus()");
    browser.press("ArrowDown");
    REQUIRE(browser.becomes_true("document.querySelector('#timeline-chart')?.dataset.shown == '3'"));
    CHECK(browser.value(of_timeline("scales.x.min")) == 450001);  // cycles of the run, whatever the sample
    CHECK(browser.value(of_timeline(bars + "[0].x[0] >= 450001")) == true);
    CHECK(browser.troubles() == Plain::array());
}

/// Three processes of each core in a circle, one that waits for it.
RunStatistics stuck_run() {
    RunStatistics run = example_run();
    run.samples.clear();
    for (std::uint64_t core = 0; core < 2; ++core) {
        run.stuck.push_back({core, "sample_dispatcher", "between loops", "sample_raster", true, 2, 2, 7 + core,
                             "rasterizer", false, "sample_dispatcher.cpp:1"});
        run.stuck.push_back({core, "rasterizer", "loop scan, iteration 3", "edge_token", true, 2, 2, 100,
                             "edge_map_builder", false, "rasterizer.cpp:2"});
        run.stuck.push_back({core, "edge_map_builder", "loop output, iteration 4", "edge_map", true, 2, 2, 200,
                             "inlier_unit", false, "edge_map_builder.cpp:3"});
        run.stuck.push_back(
            {core, "inlier_unit", "between loops", "command", false, 0, 2, 300, "rasterizer", false, hostile_text});
        run.cores[core].fifos[run.machine.fifo("edge_token")].writes += 2;
    }
    run.cores[1].fifos[run.machine.fifo("edge_map")].writes += 2;
    return run;
}

TEST_CASE("The page of a deadlock draws the circle, and says what frees it, on a phone as well", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    std::string const key = "accelerator.fifos.edge_token.depth";
    folder.write("deadlock.html",
                 report::deadlock_html(hostile_text, {"faster-sim run a.yaml", {key + "=2", "b=1"}}, stuck_run(),
                                       example_keys(), {packed_example_timeline(0, 0, 1)}));
    LiveBrowser browser(390, 900);
    browser.open("file://" + (folder / "deadlock.html").string());
    REQUIRE(browser.becomes_true("document.readyState == 'complete'"));
    auto const texts = [&browser](std::string const& selector) {
        return browser.value("[...document.querySelectorAll(\"" + selector + "\")].map((e) => e.textContent)");
    };
    CHECK(texts(".wait-circle rect:not(.what) + text") ==
          Plain::array({"rasterizer", "edge_map_builder", "inlier_unit"}));
    CHECK(texts(".wait-circle .what + text") ==
          Plain::array({"edge_token full, 2 of 2", "edge_map full, 2 of 2", "command empty, 0 of 2"}));
    CHECK(texts("#deadlock li")[1] ==
          "edge_map_builder waits for inlier_unit since cycle 200: edge_map is full, 2 of 2 tokens (loop output, "
          "iteration 4, edge_map_builder.cpp:3).");
    CHECK(texts(".way-out")[0] ==
          "At least one of these has to be larger: " + key +
              " (now 2), accelerator.fifos.edge_map.depth (now 2): the others of the circle can go on "
              "then, as far as other FIFOs let them.");
    CHECK(texts("#commands")[0] == "faster-sim run a.yaml --set b=1 --set " + key +
                                       "=4096 --set accelerator.fifos.edge_map.depth=4096 --events "
                                       "deep.events\nfaster-sim size-fifos deep.events --within 5 --points 0");
    CHECK(texts("#before")[0] == "faster-sim run a.yaml --set " + key + "=2 --set b=1 --fst stuck.fst --vcd-from 0");
    CHECK(browser.value("document.querySelectorAll('#graph-box .process.stuck').length") == 3);
    CHECK(browser.value("document.querySelectorAll('#graph-box .process.waiting:not(.stuck)').length") == 1);
    CHECK(browser.value("document.querySelectorAll('h1 *, td *:not(.tag)').length") == 0);

    CHECK(browser.becomes_true("document.querySelector('#timeline-chart')?.dataset.shown == '0'"));
    CHECK(texts("#timeline-note")[0] ==
          "Sample 0 on core 0: 345,000 cycles, 1 to 345,000. Nothing moves after cycle 300.");
    CHECK(browser.value(of_timeline("data.datasets.some((set) => set.data.length > 0)")) == true);

    std::string const held = "#fifo-table tr:has(th:first-child) td:nth-child(4)";
    Plain const of_first = texts(held);
    browser.value("document.querySelector('#fifo-controls select').focus()");
    browser.press("ArrowDown");
    CHECK(
        browser.becomes_true("[...document.querySelectorAll('#fifo-table tbody tr')].filter((row) => "
                             "row.cells[5].textContent == 'full').length == 2"));
    CHECK(texts(held) != of_first);
    browser.click("#stuck-table thead th:last-child button");
    CHECK(texts("#stuck-table tbody tr:first-child th")[0] == "inlier_unit");  // since cycle 300
    CHECK(browser.value("document.documentElement.scrollWidth <= innerWidth") == true);
    CHECK(browser.troubles() == Plain::array());
}

TEST_CASE("Hostile names are text in the drawn page", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("report.html", example_page(hostile_text));
    Json const check = self_check(folder, "report.html");
    CHECK(check["title"] == hostile_text + " - faster-sim");
    CHECK(check["pictures"] == 1);
    CHECK(check["elements_in_data"] == 0);
    Json const& values = column(check, "Configuration", "value")["ascending"];
    CHECK(std::find(values.begin(), values.end(), hostile_text) != values.end());
}

TEST_CASE("A run without samples is drawn, too", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    RunStatistics const empty = testing::idle_run(testing::raster_machine({}), 0);
    folder.write("report.html", report::html_report({"empty", empty, {}, {}, {}}));
    Json const check = self_check(folder, "report.html");
    CHECK(check["sections"] ==
          Json::array({"summary", "graph", "modules", "fifos", "loops", "resources", "configuration"}));
}

TEST_CASE("The browser draws the traffic of an external memory", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    RunStatistics run = example_run();
    run.machine.external_memory.emplace();
    MemoryTraffic traffic;
    traffic.masters = {{0, "vertex", 0, 3, 768, 51, 60, 70, 80}, {1, "vertex", 1, 20, 5120, 52, 61, 71, 81}};
    traffic.port_beats = {48, 320};
    traffic.stretches = {{768, 1}, {5120, 4}};
    run.memory = traffic;
    folder.write("report.html", report::html_report({"memory", run, example_keys(), {}, {}}));
    Json const check = self_check(folder, "report.html");
    std::vector<std::string> const sections = check["sections"];
    CHECK(std::find(sections.begin(), sections.end(), "external-memory") != sections.end());
    CHECK(column(check, "Ports", "port")["ascending"] == Json::array({"0", "1"}));
    CHECK(column(check, "Masters; latencies of bursts in cycles", "bytes")["descending"].front() == "5,120");
}

TEST_CASE("The page fits a phone, in the dark as well", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("report.html", example_page("a_configuration_with_a_long_name_and_no_place_to_break_it.yaml"));
    // A window has 500 px at least, a frame has not.
    folder.write("phone.html",
                 "<iframe width=360 height=740 src='report.html#self-check'></iframe><script>onload = async () => {"
                 "let found; while (!(found = frames[0].document.getElementById('self-check')))"
                 "await new Promise((go) => setTimeout(go, 5)); document.body.append(found)}</script>");
    for (Words const& options : {Words{}, Words{"--blink-settings=preferredColorScheme=0"}}) {
        Json const check = json_element(drawn_page(folder, "phone.html", options), "self-check");
        CHECK(check["errors"] == Json::array());
        CHECK(check["painted"] == 8);
        CHECK(check["window_width"] <= 360);
        CHECK(check["page_width"] == check["window_width"]);
        CHECK(check["dark"] == !options.empty());
    }
}

}  // namespace html_report_browser_test
