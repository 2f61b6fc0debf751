#include <catch2/catch.hpp>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"

namespace architectures_test {

using namespace faster::test;
namespace fs = std::filesystem;

struct Preset {
    std::string file;
    std::string algorithm;
    int token_ii;
    int edge_map_bits;
    int object_map_bits;
};

nlohmann::json summary_of(Preset const& preset) {
    fs::path const source = FASTER_SOURCE_DIR;
    fs::path const config = source / "configs" / "architectures" / (preset.file + ".yaml");
    TempFolder const folder;
    require_done(
        run_command(FASTER_SIM_BINARY,
                    {"run", config.string(), "--trace", (source / "traces" / "one_triangle").string(), "--out", "out"},
                    folder.path()));
    return nlohmann::json::parse(content_of(folder / "out" / "summary.json"));
}

/// The row of core 0 whose cell `column` is `name`.
nlohmann::json row_of(nlohmann::json const& table, std::string const& column, std::string const& name) {
    for (auto const& row : table)
        if (row.at("core") == 0 && row.at(column) == name)
            return row;
    return {};
}

TEST_CASE("Our own designs hold with the FIFOs of every generation", "[architectures]") {
    fs::path const source = FASTER_SOURCE_DIR;
    TempFolder const folder;
    for (std::string const preset : {"next", "next_double_buffers", "next_zcu102"})
        for (std::string const trace : {"tomato_soup_can", "cracker_box"}) {
            CAPTURE(preset, trace);
            std::map<std::string, std::int64_t> totals;
            for (std::string const rules : {"spec", "vivado_hls", "vitis_hls"}) {
                require_done(
                    run_command(FASTER_SIM_BINARY,
                                {"run", (source / "configs/architectures" / (preset + ".yaml")).string(), "--trace",
                                 (source / "traces" / trace).string(), "--set", "accelerator.raster_cores=1", "--set",
                                 "accelerator.fifo_rules=" + rules, "--out", "out"},
                                folder.path()));
                nlohmann::json const summary = nlohmann::json::parse(content_of(folder / "out" / "summary.json"));
                totals[rules] = summary["total_cycles"];
                bool const is_memory = rules == "spec" && preset != "next_zcu102";  // which has depths of 2 there
                CHECK(row_of(summary["fifos"], "fifo", "vertex")["kind"] == (is_memory ? "memory" : "shift_register"));
            }
            CAPTURE(totals["spec"], totals["vivado_hls"], totals["vitis_hls"]);
            CHECK(std::abs(totals["vivado_hls"] - totals["spec"]) * 100 <= totals["spec"]);
            CHECK(std::abs(totals["vitis_hls"] - totals["spec"]) * 100 <= totals["spec"]);
        }
}

TEST_CASE("The presets of the thesis's designs run, with their intervals and memories", "[architectures]") {
    for (Preset const& preset :
         {Preset{"threshold", "threshold", 2, 2, 0}, Preset{"transition", "transition", 2, 2, 0},
          Preset{"bounded", "bounded", 3, 2, 0}, Preset{"faster", "dual_map", 1, 1, 1},
          Preset{"dual_map_4_1_2", "dual_map_4_1_2", 2, 1, 1}, Preset{"inner_border", "inner_border", 1, 0, 1}}) {
        CAPTURE(preset.file);
        nlohmann::json const summary = summary_of(preset);
        CHECK(summary["configuration"]["accelerator.edge_map.algorithm"]["value"] == preset.algorithm);
        CHECK(row_of(summary["loops"], "loop", "token")["ii"] == preset.token_ii);
        auto const edge_map = row_of(summary["brams"], "bram", "edge_map");
        auto const object_map = row_of(summary["brams"], "bram", "object_map");
        CHECK(edge_map["bits"] == preset.edge_map_bits);
        CHECK(edge_map["words"] == (preset.edge_map_bits > 0 ? 32 * 32 : 0));
        CHECK(edge_map["ramb36"] == (preset.edge_map_bits > 0 ? 0.5 : 0));
        CHECK(object_map["bits"] == preset.object_map_bits);
        CHECK(object_map["words"] == (preset.object_map_bits > 0 ? 32 * 32 : 0));
    }
}

TEST_CASE("The presets beyond the thesis read and clear the depth buffer as they say", "[architectures]") {
    struct Beyond {
        std::string file;
        int sweep_ii;
        bool clears_in_a_loop;
        bool has_line_buffers;
    };
    for (Beyond const& preset :
         {Beyond{"faster", 3, true, false}, Beyond{"line_buffers", 1, true, true},
          Beyond{"clear_on_read_out", 3, false, false}, Beyond{"line_buffers_clear_on_read_out", 1, false, true},
          Beyond{"banked_depth_buffer", 1, true, false}, Beyond{"wide_clearing", 2, true, false},
          Beyond{"sweep_lanes_4", 1, false, true}}) {
        CAPTURE(preset.file);
        nlohmann::json const summary = summary_of({preset.file, "", 0, 0, 0});
        CHECK(row_of(summary["loops"], "loop", "sweep")["ii"] == preset.sweep_ii);
        CHECK((row_of(summary["loops"], "loop", "clear")["entries"] > 0) == preset.clears_in_a_loop);
        CHECK(row_of(summary["brams"], "bram", "line_buffers").is_null() != preset.has_line_buffers);
    }
}

TEST_CASE("The presets of faster rasterizers run, with fewer iterations or loops each", "[architectures]") {
    auto const iterations = [](nlohmann::json const& summary, char const* loop) {
        return row_of(summary["loops"], "loop", loop)["iterations"].get<int>();
    };
    auto const summary = [](char const* preset) { return summary_of({preset, "", 0, 0, 0}); };
    nlohmann::json const thesis = summary("line_buffers_clear_on_read_out");
    nlohmann::json const overlap = summary("setup_overlap");
    nlohmann::json const early = summary("early_exit");
    nlohmann::json const spans = summary("spans");
    nlohmann::json const flattened = summary("flattened_fragments");
    // docs/modules/rasterizer.md: 5 x 6 pixels and 2 flushes; 15 fragments, 5 edge tokens. One loop for all: three more
    // read the vertices, one announces the triangle.
    CHECK(iterations(thesis, "scan") == 32);
    CHECK(iterations(overlap, "scan") == 4 + 32);
    CHECK(iterations(spans, "scan") == 4 + 15 + 5);
    // Rows 20 and 21 run from wall to wall; row 22 turns at column 33, two behind the run of row 23; row 24 ends at 31.
    CHECK(iterations(early, "scan") == 4 + 6 + 6 + 4 + 4 + 2 + 2);
    CHECK(iterations(spans, "fragment") == 15);
    // Rows 20 to 24, columns 30 to 34, and a pixel around.
    CHECK(iterations(summary("touched_region"), "sweep") == 7 * 7);
    CHECK(iterations(flattened, "fragment") == 1 + 15);
    for (nlohmann::json const& faster : {overlap, early, spans, flattened})
        CHECK(faster["total_cycles"] < thesis["total_cycles"]);
}

/// Cycles of presets on classes, by preset and class; `samples` of each.
std::map<std::string, std::map<std::string, std::uint64_t>> swept(std::string const& presets,
                                                                  std::vector<std::string> const& classes,
                                                                  int samples) {
    TempFolder const folder;
    std::string files;
    for (std::string const& name : classes)
        files += FASTER_SOURCE_DIR "/configs/" + name + ".yaml, ";
    folder.write("sweep.yaml",
                 "format: faster-sweep\nversion: 1\nset: {workload.samples.count: " + std::to_string(samples) +
                     "}\ndimensions:\n  - {key: accelerator.architecture, values: [" + presets +
                     "]}\n  - {overlay: class, files: [" + files + "]}\n");
    require_done(run_command(FASTER_SIM_BINARY, {"sweep", "sweep.yaml", "--out", "out"}, folder.path()));
    std::map<std::string, std::map<std::string, std::uint64_t>> cycles;
    std::vector<std::string> const lines = lines_of(content_of(folder / "out" / "results.csv"));
    for (std::size_t i = 1; i < lines.size(); ++i) {
        std::vector<std::string> const cells = cells_of(lines[i]);
        REQUIRE(cells.at(3) == "done");
        cycles[cells.at(1)][fs::path(cells.at(2)).stem().string()] = std::stoull(cells.at(4));
    }
    return cycles;
}

TEST_CASE("Our own designs take a twentieth of the time on all five classes", "[architectures]") {
    std::vector<std::string> const classes{"potted_meat_can", "banana", "mustard_bottle", "cracker_box",
                                           "tomato_soup_can"};
    auto cycles = swept("faster, next, next_double_buffers", classes, 60);
    for (std::string const& name : classes) {
        CAPTURE(name, cycles["faster"][name], cycles["next"][name], cycles["next_double_buffers"][name]);
        REQUIRE(cycles["next"][name] > 0);
        CHECK(20 * cycles["next"][name] <= cycles["faster"][name]);
        CHECK(20 * cycles["next_double_buffers"][name] <= cycles["faster"][name]);
        CHECK(cycles["next_double_buffers"][name] <=
              cycles["next"][name] * 104 / 100);  // of so few samples, the last sweep counts
    }
}

TEST_CASE("Our own design takes a sixteenth of the time with the memory of the board", "[architectures]") {
    auto cycles = swept("faster, next_zcu102", {"cracker_box"}, 240);
    CAPTURE(cycles["faster"]["cracker_box"], cycles["next_zcu102"]["cracker_box"]);
    REQUIRE(cycles["next_zcu102"]["cracker_box"] > 0);
    CHECK(16 * cycles["next_zcu102"]["cracker_box"] <= cycles["faster"]["cracker_box"]);
}

TEST_CASE("The shipped sweep over architectures has every preset", "[architectures]") {
    fs::path const source = FASTER_SOURCE_DIR;
    std::string const sweep = content_of(source / "configs/sweeps/architectures.yaml");
    for (auto const& entry : fs::directory_iterator(source / "configs/architectures"))
        CHECK_THAT(sweep, Catch::Matches("[^]*[\\[ ]" + entry.path().stem().string() + "[,\\]][^]*"));
}

}  // namespace architectures_test
