#include <catch2/catch.hpp>

#include "dataflow/tools/sweeps/sweep_page.hpp"
#include "faster/dataflow_names.hpp"
#include "support/browser.hpp"

namespace sweep_page_browser_test {

using namespace faster;
using namespace faster::test;
using Json = nlohmann::ordered_json;
using sweeps::Manifest;
using sweeps::PointResult;
using sweeps::Results;

PointResult done(Cycles cycles, double ramb36) {
    PointResult result;
    result.status = PointResult::Status::done;
    result.total_cycles = cycles;
    result.ramb36 = ramb36;
    return result;
}

/// Six points; 1, 2 and 3 are on the front of cycles and block RAMs, 0 is beaten, 4 deadlocked, 5 failed.
std::string page() {
    Manifest manifest;
    manifest.sweep = "<i>&amp;.yaml";
    manifest.columns = {"design", "accelerator.raster_cores", "accelerator.window"};
    Results results;
    std::vector<PointResult> const all{
        done(500, 40), done(100, 90), done(300, 20), done(100, 90), {}, sweeps::failed("</script>")};
    for (std::size_t i = 0; i < all.size(); ++i) {
        manifest.points.push_back(
            {std::to_string(i), {"designs/<b>" + std::to_string(i % 2) + ".yaml", std::to_string(i), "40"}});
        results[std::to_string(i)] = all[i];
    }
    results["4"].status = PointResult::Status::deadlock;
    return sweep_page(manifest, results);
}

TEST_CASE("The browser draws the page of a sweep, and finds its Pareto front", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    folder.write("index.html", page());
    Json const check = self_check(folder, "index.html");
    CHECK(check["charts"] == 2);
    CHECK(check["front"] == Json::array({1, 3, 2}));
    // what does not vary has no axis, and neither have figures that are all the same
    CHECK(check["axes"] == Json::array({"design", "accelerator.raster_cores", "total cycles", "RAMB36"}));
    CHECK(check["rows"] == 6);
    CHECK(check["rows_on_front"] == 3);
    CHECK(check["rows_in_range"] == Json::array({"0", "1", "2"}));
    CHECK(check["front_of_same_figure"] == Json::array({1, 3}));
}

TEST_CASE("The page of a sweep without results is drawn too", "[browser]") {
    if (browser_is_missing())
        return;
    TempFolder const folder;
    Manifest manifest;
    manifest.sweep = "empty.yaml";
    manifest.columns = {"accelerator.window"};
    manifest.points = {{"0", {"40"}}};
    folder.write("index.html", sweeps::sweep_page(manifest, {}));
    CHECK(self_check(folder, "index.html")["rows"] == 0);
}

}  // namespace sweep_page_browser_test
