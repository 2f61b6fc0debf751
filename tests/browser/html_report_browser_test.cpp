#include <algorithm>
#include <catch2/catch.hpp>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "kernel/report/html/html_report.hpp"
#include "support/browser.hpp"
#include "support/example_run.hpp"
#include "support/idle_run.hpp"
#include "support/raster_machine.hpp"
#include "support/report_page.hpp"
#include "support/temp_folder.hpp"

namespace html_report_browser_test {

using namespace faster;
using namespace faster::test;
using Json = nlohmann::ordered_json;
using Words = std::vector<std::string>;

std::string png_of(int side) {
    std::vector<unsigned char> bytes;
    cv::imencode(".png", cv::Mat(side, side, CV_8UC3, cv::Scalar(60, 120, 180)), bytes);
    return {bytes.begin(), bytes.end()};
}

std::string example_page(std::string const& title) {
    return report::html_report({title,
                                example_run(),
                                example_keys(),
                                {example_timeline(0, 0, 1), example_timeline(1, 3, 450001)},
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
    CHECK(check["sections"] == Json::array({"summary", "graph", "modules", "critical-path", "sensitivities", "timeline",
                                            "fifos", "loops", "latency", "pictures", "configuration"}));
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
    CHECK(check["samples"]["0 (core 0)"] == "Sample 0 on core 0: 345,000 cycles from cycle 1 on.");
    CHECK(check["samples"]["3 (core 1)"] == "Sample 3 on core 1: 345,000 cycles from cycle 450,001 on.");
    CHECK(check["zoomed"] == Json::array({345000, 345000 / 256.0, 345000}));
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
    CHECK(check["sections"] == Json::array({"summary", "graph", "modules", "fifos", "loops", "configuration"}));
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
                 "<iframe width=360 height=740 src='report.html#self-check'></iframe><script>onload = () => "
                 "document.body.append(frames[0].document.getElementById('self-check'))</script>");
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
