#include <catch2/catch.hpp>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "faster/dataflow_names.hpp"
#include "support/command.hpp"
#include "support/temp_folder.hpp"
#include "support/tool_output.hpp"
#include "support/vcd_reader.hpp"
#include "support/waves.hpp"

namespace waveform_test {

using namespace faster::test;
using Row = Waves::Row;

Words const fifo_names{"sample_vertex",   "sample_raster",  "sample_observation", "vertex",         "area",
                       "area_reciprocal", "command",        "fragment_depth",     "fragment_index", "edge_token",
                       "edge_map",        "observed_depth", "observed_edge",      "result",         "region",
                       "valid_depth",     "map_full",       "map_free",           "depth_full",     "depth_free"};
Words const module_names{"sample_dispatcher", "vertex_transform",   "rasterizer",  "area_reciprocal",
                         "edge_map_builder",  "observation_reader", "inlier_unit", "result_collector",
                         "edge_map_output",   "inlier_sweep"};

std::uint64_t number(Row const& row, std::string const& column) { return std::stoull(row.at(column)); }

/// What a waveform says of a FIFO must be what fifos.csv says.
void check_fifo(Vcd const& vcd, Row const& row) {
    std::string const core = "core_" + row.at("core");
    std::string const fifo = core + ".fifo_" + row.at("fifo");
    CAPTURE(fifo);
    auto const at = std::find(fifo_names.begin(), fifo_names.end(), row.at("fifo")) - fifo_names.begin();
    auto const empty = static_cast<std::uint64_t>(1 + 2 * at);
    std::uint64_t empty_cycles = 0;
    std::uint64_t full_cycles = 0;
    for (std::string const& module : module_names) {
        if (vcd.signals.count(core + "." + module + ".stall") == 0)
            continue;
        empty_cycles += vcd.duration(core + "." + module + ".stall", empty);
        full_cycles += vcd.duration(core + "." + module + ".stall", empty + 1);
    }
    CHECK(vcd.duration(fifo + ".write", 1) == number(row, "writes"));
    CHECK(vcd.duration(fifo + ".read", 1) == number(row, "reads"));
    CHECK(empty_cycles == number(row, "empty_stall_cycles"));
    CHECK(full_cycles == number(row, "full_stall_cycles"));
    CHECK(vcd.largest(fifo + ".occupancy") == number(row, "max_occupancy"));
}

/// Occupancy, full and empty follow from writes and reads, and every token read is the one that was written.
void check_tokens(Vcd const& vcd, std::string const& fifo, std::vector<std::string> const& fields) {
    CAPTURE(fifo);
    for (std::string const& field : fields) {
        auto const written = vcd.sampled(fifo + ".written_" + field, fifo + ".write");
        auto const read = vcd.sampled(fifo + ".read_" + field, fifo + ".read");
        REQUIRE(written.size() == read.size());
        for (std::size_t i = 0; i < read.size(); ++i) {
            CHECK(read[i].bits == written[i].bits);
            CHECK(read[i].cycle > written[i].cycle);
        }
    }
    for (Vcd::Value const& value : vcd.signals.at(fifo + ".occupancy"))
        if (value.known)
            CHECK(vcd.at(fifo + ".empty", value.cycle).bits == (value.bits == 0 ? 1 : 0));
}

void check_samples(Vcd const& vcd, std::vector<Row> const& rows) {
    std::map<std::uint64_t, std::pair<std::uint64_t, std::uint64_t>> found;
    for (std::string const core : {"core_0", "core_1"}) {
        for (Vcd::Value const& start : vcd.sampled(core + ".sample.started", core + ".sample.start"))
            found[start.bits].first = start.cycle;
        for (Vcd::Value const& end : vcd.sampled(core + ".sample.ended", core + ".sample.end"))
            found[end.bits].second = end.cycle;
    }
    REQUIRE(found.size() == rows.size());
    for (Row const& row : rows) {
        CHECK(found.at(number(row, "sample")).first == number(row, "start_cycle"));
        CHECK(found.at(number(row, "sample")).second == number(row, "end_cycle"));
    }
}

TEST_CASE("A waveform says what the tables say, in both engines alike", "[vcd]") {
    for (std::string const trace : {"empty", "one_triangle", "edge_heavy", "full_window"}) {
        CAPTURE(trace);
        Waves const waves;
        for (std::string const engine : {"lockstep", "decoupled"})
            require_done_with_warnings(waves.run(
                trace, {"--set", "simulation.engine=" + engine, "--set", "accelerator.fifos.area_reciprocal.depth=1",
                        "--vcd", engine + ".vcd", "--timeline", engine + ".json", "--out", engine}));
        CHECK(waves.text("lockstep.vcd") == waves.text("decoupled.vcd"));
        CHECK(waves.text("lockstep.json") == waves.text("decoupled.json"));
        Vcd const vcd = waves.vcd("lockstep.vcd");
        CHECK(vcd.timescale == " 1 ns ");
        for (Row const& row : waves.table("lockstep/fifos.csv"))
            check_fifo(vcd, row);
        check_tokens(vcd, "core_0.fifo_vertex", {"x", "y", "z"});
        check_tokens(vcd, "core_0.fifo_edge_token", {"row", "col", "kind"});
        check_tokens(vcd, "core_1.fifo_result", {"valid_raster", "inlier"});
        check_samples(vcd, waves.table("lockstep/samples.csv"));
    }
}

TEST_CASE("A waveform's loops are those of the table, and no block RAM has more accesses than ports", "[vcd]") {
    Waves const waves;
    require_done(waves.run("edge_heavy", {"--vcd", "all.vcd", "--out", "out"}));
    Vcd const vcd = waves.vcd("all.vcd");
    std::map<std::string, std::uint64_t> const states{
        {"scan", 2}, {"token", 4}, {"output", 5}, {"fragment", 8}, {"sweep", 9}};
    for (Row const& row : waves.table("out/loops.csv")) {
        auto const state = states.find(row.at("loop"));
        if (state == states.end() || row.at("core") != "0")
            continue;
        CAPTURE(row.at("loop"));
        std::string const module = "core_0." + row.at("module");
        std::uint64_t entries = 0;
        for (Vcd::Value const& value : vcd.signals.at(module + ".state"))
            entries += value.known && value.bits == state->second ? 1U : 0U;
        CHECK(entries >= number(row, "entries"));  // those without an iteration count here
    }
    // The sweep reads five pixels of all but the border; 32 x 32 pixels, and the samples of core 0.
    std::uint64_t reads = 0;
    for (std::string const port : {"0", "1"}) {
        std::string const path = "core_0.bram_depth_buffer.port" + port;
        reads += vcd.duration(path + "_enable", 1) - vcd.duration(path + "_write_enable", 1);
    }
    std::uint64_t samples = 0;
    for (Row const& row : waves.table("out/samples.csv"))
        samples += row.at("core") == "0" ? 1U : 0U;
    std::uint64_t fragments_inside = 0;
    auto const rows = vcd.sampled("core_0.fifo_fragment_index.read_row", "core_0.fifo_fragment_index.read");
    auto const cols = vcd.sampled("core_0.fifo_fragment_index.read_col", "core_0.fifo_fragment_index.read");
    for (std::size_t i = 0; i < rows.size(); ++i)
        fragments_inside += rows[i].bits < 32 && cols[i].bits < 32 ? 1U : 0U;
    CHECK(reads == samples * 5 * 30 * 30 + fragments_inside);
}

TEST_CASE("A waveform shows what was selected", "[vcd]") {
    Waves const waves;
    require_done(waves.run("one_triangle", {"--vcd", "a.vcd", "--vcd-cores", "0", "--vcd-modules", "edge*"}));
    Vcd const vcd = waves.vcd("a.vcd");
    CHECK(vcd.signals.count("core_0.edge_map_builder.state") == 1);
    CHECK(vcd.signals.count("core_0.fifo_edge_token.write") == 1);
    CHECK(vcd.signals.count("core_0.bram_object_map.port0_enable") == 1);
    CHECK(vcd.signals.count("core_0.inlier_unit.state") == 0);
    CHECK(vcd.signals.count("core_0.fifo_vertex.write") == 0);
    CHECK(vcd.signals.count("core_1.edge_map_builder.state") == 0);
    // The save file and its tables name what is there.
    for (std::string const& line : lines_of(waves.text("a.gtkw")))
        if (line.rfind("accelerator.", 0) == 0) {
            std::string const path = line.substr(12, line.find('[') - 12);
            CAPTURE(path);
            CHECK(vcd.signals.count(path) == 1);
        }
    CHECK(waves.text("a.states.txt").find("04 token\n") != std::string::npos);
    CHECK(waves.text("a.stalls.txt").find("14 edge_token full\n") != std::string::npos);
}

TEST_CASE("A waveform shows the memory accesses of each edge map algorithm", "[vcd][edge_map]") {
    // one_triangle: window 32, 15 object tokens and 5 edge tokens, none at the window's border; 15 fragments.
    auto const accesses = [](std::string const& algorithm, std::string const& bram) {
        Waves const waves;
        require_done(waves.run("one_triangle", {"--vcd", "a.vcd", "--vcd-cores", "0", "--set",
                                                "accelerator.edge_map.algorithm=" + algorithm}));
        Vcd const vcd = waves.vcd("a.vcd");
        return vcd.duration("core_0.bram_" + bram + ".port0_enable", 1) +
               vcd.duration("core_0.bram_" + bram + ".port1_enable", 1);
    };
    std::uint64_t const clear_and_output = 2 * 1024;
    CHECK(accesses("transition", "edge_map") == clear_and_output + 15 * 1 + 5 * 2);
    CHECK(accesses("transition", "object_map") == 0);
    CHECK(accesses("bounded", "edge_map") == clear_and_output + 15 * 5 + 5 * 2);
    CHECK(accesses("dual_map", "edge_map") == clear_and_output + 15 * 3 + 5 * 1);
    CHECK(accesses("dual_map", "object_map") == 1024 + 15 * 3 + 5 * 1);
    CHECK(accesses("dual_map_4_1_2", "object_map") == 1024 + 15 * 3 + 5 * 1);
    CHECK(accesses("inner_border", "edge_map") == 0);
    CHECK(accesses("inner_border", "object_map") == clear_and_output + 15);
    CHECK(accesses("inner_border", "depth_buffer") == 1024 + 15 * 2 + 30 * 30);
    CHECK(accesses("dual_map", "depth_buffer") == 1024 + 15 * 2 + 5 * 30 * 30);
}

TEST_CASE("A waveform shows what line buffers and clearing on read-out do to the memories", "[vcd][edge_map]") {
    auto const accesses = [](Words const& settings, std::string const& bram) {
        Waves const waves;
        Words options{"--vcd", "a.vcd", "--vcd-cores", "0"};
        for (std::string const& setting : settings)
            options.insert(options.end(), {"--set", setting});
        require_done(waves.run("one_triangle", options));
        Vcd const vcd = waves.vcd("a.vcd");
        return vcd.duration("core_0.bram_" + bram + ".port0_enable", 1) +
               vcd.duration("core_0.bram_" + bram + ".port1_enable", 1);
    };
    std::string const window = "accelerator.inlier_unit.neighbour_access=window";
    std::string const clears = "accelerator.inlier_unit.clearing=on_read_out";
    CHECK(accesses({window}, "depth_buffer") == 1024 + 15 * 2 + 1024);
    CHECK(accesses({clears}, "depth_buffer") == 15 * 2 + 5 * 30 * 30 + 1024);
    CHECK(accesses({window, clears}, "depth_buffer") == 15 * 2 + 1024 + 1024);
    std::string const map_clears = "accelerator.edge_map.clearing=on_read_out";
    CHECK(accesses({map_clears}, "edge_map") == 15 * 3 + 5 * 1 + 2 * 1024);
    CHECK(accesses({map_clears}, "object_map") == 15 * 3 + 5 * 1 + 1024);
    // The triangle's 5 x 5 pixels, and one around.
    std::string const touched = "accelerator.inlier_unit.sweep_region=touched";
    CHECK(accesses({touched}, "depth_buffer") == 1024 + 15 * 2 + 5 * 49);
    CHECK(accesses({touched, window}, "depth_buffer") == 1024 + 15 * 2 + 49);
    CHECK(accesses({touched, clears}, "depth_buffer") == 15 * 2 + 5 * 49 + 49);
    CHECK(accesses({touched, map_clears}, "edge_map") == 15 * 3 + 5 * 1 + 2 * 49);
    CHECK(accesses({touched, map_clears}, "object_map") == 15 * 3 + 5 * 1 + 49);
}

TEST_CASE("A waveform shows the corners of a touched region on their FIFOs", "[vcd][sweep_region]") {
    Waves const waves;
    require_done(waves.run("one_triangle", {"--vcd", "a.vcd", "--vcd-cores", "0", "--set",
                                            "accelerator.inlier_unit.sweep_region=touched"}));
    Vcd const vcd = waves.vcd("a.vcd");
    CHECK(vcd.duration("core_0.fifo_region.write", 1) == 2);
    CHECK(vcd.duration("core_0.fifo_region.read", 1) == 2);
    CHECK(vcd.duration("core_0.fifo_valid_depth.read", 1) == 1);
    CHECK(vcd.duration("core_0.fifo_observed_depth.write", 1) == 49);
    auto const rows = vcd.sampled("core_0.fifo_region.read_row", "core_0.fifo_region.read");
    REQUIRE(rows.size() == 2);
    CHECK(rows[1].bits - rows[0].bits == 6);
}

TEST_CASE("A waveform shows the region of a finished buffer in its token", "[vcd][sweep_region][double_buffers]") {
    Waves const waves;
    auto const run_with = [&](std::string const& region) {
        require_done(waves.run(
            "one_triangle",
            {"--vcd", "a.vcd", "--vcd-cores", "0", "--set", "accelerator.edge_map.buffers=2", "--set",
             "accelerator.inlier_unit.buffers=2", "--set", "accelerator.inlier_unit.sweep_region=" + region}));
        return waves.vcd("a.vcd");
    };
    Vcd const touched = run_with("touched");
    for (std::string const full : {"core_0.fifo_map_full", "core_0.fifo_depth_full"}) {
        CAPTURE(full);
        CHECK(touched.sampled(full + ".read_buffer", full + ".read").at(0).bits == 0);
        for (std::string const axis : {"row", "col"}) {
            std::uint64_t const first = touched.sampled(full + ".read_first_" + axis, full + ".read").at(0).bits;
            std::uint64_t const last = touched.sampled(full + ".read_last_" + axis, full + ".read").at(0).bits;
            auto const corners = touched.sampled("core_0.fifo_region.read_" + axis, "core_0.fifo_region.read");
            CHECK(first == corners.at(0).bits);
            CHECK(last == corners.at(1).bits);
        }
    }
    // The accesses of one buffer of which 49 pixels are read out, as with one: the ports of either buffer are its own.
    CHECK(touched.duration("core_0.bram_depth_buffer.buffer0_port0_enable", 1) +
              touched.duration("core_0.bram_depth_buffer.buffer0_port1_enable", 1) ==
          1024 + 15 * 2 + 5 * 49);
    Vcd const window = run_with("window");
    CHECK(window.signals.count("core_0.fifo_map_full.read_buffer") == 1);
    CHECK(window.signals.count("core_0.fifo_map_full.read_first_row") == 0);
    CHECK(window.signals.count("core_0.fifo_depth_full.read_valid_raster") == 1);
    CHECK(window.signals.count("core_0.fifo_depth_full.read_last_col") == 0);
}

TEST_CASE("A waveform shows banks and lanes", "[vcd][partition][lanes]") {
    Waves const waves;
    Words const settings{"accelerator.inlier_unit.neighbour_access=window",
                         "accelerator.inlier_unit.clearing=wide",
                         "accelerator.inlier_unit.sweep_lanes=5",
                         "accelerator.brams.depth_buffer.partition.type=cyclic",
                         "accelerator.brams.depth_buffer.partition.factor=5",
                         "accelerator.brams.depth_buffer.partition.dimension=2"};
    Words options{"--vcd", "a.vcd", "--vcd-cores", "0"};
    for (std::string const& setting : settings)
        options.insert(options.end(), {"--set", setting});
    require_done(waves.run("one_triangle", options));
    Vcd const vcd = waves.vcd("a.vcd");
    auto const accesses = [&vcd](std::string const& bank) {
        std::string const port = "core_0.bram_depth_buffer." + bank + "_port";
        return vcd.duration(port + "0_enable", 1) + vcd.duration(port + "1_enable", 1);
    };
    // 32 columns: seven in the first two banks, six in the others. Which of them has the fragments is left open.
    std::uint64_t sum = 0;
    for (int bank = 0; bank < 5; ++bank)
        sum += accesses("bank" + std::to_string(bank));
    CHECK(sum == 1024 + 15 * 2 + 1024);
    CHECK(accesses("bank0") >= 7 * 32 * 2);
    CHECK(vcd.duration("core_0.fifo_observed_depth.write", 1) == 32 * 7);
    CHECK(vcd.duration("core_0.fifo_edge_map.read", 1) == 32 * 7);
    CHECK(vcd.duration("core_0.fifo_edge_map.written_edge4", 1) > 0);
}

TEST_CASE("A waveform shows groups of pixels, and each of their memory accesses", "[vcd][partition][lanes]") {
    Waves const waves;
    Words options{"--vcd", "a.vcd", "--vcd-cores", "0"};
    for (std::string const& setting :
         Words{"accelerator.edge_map.algorithm=inner_border", "accelerator.rasterizer.edge_tokens=object",
               "accelerator.rasterizer.lanes=4", "accelerator.brams.depth_buffer.partition.type=cyclic",
               "accelerator.brams.depth_buffer.partition.factor=4",
               "accelerator.brams.depth_buffer.partition.dimension=2"})
        options.insert(options.end(), {"--set", setting});
    require_done(waves.run("one_triangle", options));
    Vcd const vcd = waves.vcd("a.vcd");
    std::uint64_t sum = 0;
    for (char const* const port : {"bank0_port0", "bank0_port1", "bank1_port0", "bank1_port1", "bank2_port0",
                                   "bank2_port1", "bank3_port0", "bank3_port1"})
        sum += vcd.duration("core_0.bram_depth_buffer." + std::string(port) + "_enable", 1);
    CHECK(sum == 1024 + 15 * 2 + 30 * 30);
    CHECK(vcd.duration("core_0.bram_object_map.port0_enable", 1) +
              vcd.duration("core_0.bram_object_map.port1_enable", 1) ==
          2 * 1024 + 15);
    // Columns 14 to 18 of the window in the first row, one fewer in each of the four below: groups begin at 12 and 16.
    CHECK(vcd.duration("core_0.fifo_fragment_index.write", 1) == 2 + 2 + 2 + 1 + 1);
    CHECK(vcd.duration("core_0.fifo_fragment_depth.write", 1) == 8);
    CHECK(vcd.duration("core_0.fifo_edge_token.write", 1) == 8 + 1);
    CHECK(vcd.duration("core_0.fifo_fragment_index.written_mask", 0b1100) > 0);
    CHECK(vcd.duration("core_0.fifo_edge_token.read_mask", 0b0111) > 0);
}

TEST_CASE("A waveform's times fit a clock whose cycle is no whole number of nanoseconds", "[vcd]") {
    Waves const waves;
    require_done(waves.run("one_triangle", {"--vcd", "a.vcd", "--set", "accelerator.clock_mhz=400"}));
    Vcd const vcd = read_vcd(waves.path() / "a.vcd", 2500);
    CHECK(vcd.timescale == " 1 ps ");
}

TEST_CASE("A waveform has the number of the cycle, as the tables count it", "[vcd]") {
    Waves const waves;
    require_done(waves.run("one_triangle", {"--vcd", "a.vcd", "--vcd-from", "7", "--vcd-to", "40"}));
    auto const cycles = waves.vcd("a.vcd").signals.at("cycle");
    REQUIRE(cycles.size() == 35);  // and unknown after the window
    for (std::size_t i = 0; i + 1 < cycles.size(); ++i) {
        CHECK(cycles[i].cycle == 7 + i);
        CHECK(cycles[i].bits == 7 + i);
    }
}

TEST_CASE("A timeline has a track per module, stalls inside loops, and as many samples as asked for", "[timeline]") {
    Waves const waves;
    require_done(waves.run("edge_heavy", {"--timeline", "t.json", "--timeline-samples", "1", "--out", "out"}));
    auto const timeline = nlohmann::json::parse(waves.text("t.json"));
    std::size_t samples = 0;
    std::map<std::string, std::size_t> slices;
    for (auto const& event : timeline.at("traceEvents")) {
        if (event.at("ph") != "X")
            continue;
        ++slices[event.at("cat").get<std::string>()];
        samples += event.at("cat") == "sample" && event["args"]["complete"] == true ? 1U : 0U;
        if (event.at("cat") == "stall")
            CHECK(event["args"]["stalled_cycles"] <=
                  event["args"]["end_cycle"].get<int>() + 1 - event["args"]["begin_cycle"].get<int>());
    }
    CHECK(samples == 2);  // one of each core
    CHECK(slices["loop"] > 10);
    CHECK(slices["stall"] > 10);
}

/// As Perfetto's trace processor takes times from JSON, in ns.
std::int64_t nanoseconds(nlohmann::json const& time) {
    return time.is_number_integer() ? time.get<std::int64_t>() * 1000
                                    : static_cast<std::int64_t>(time.get<double>() * 1000.0);
}

/// Slices that it drops: those that begin inside another of their track, and end behind it.
std::vector<std::string> dropped_slices(nlohmann::json const& timeline) {
    struct Slice {
        std::int64_t begin, end;
        std::string text;
    };
    std::map<std::pair<int, int>, std::vector<Slice>> tracks;
    for (auto const& event : timeline.at("traceEvents"))
        if (event.at("ph") == "X") {
            std::int64_t const begin = nanoseconds(event.at("ts"));
            tracks[{event.at("pid"), event.at("tid")}].push_back(
                {begin, begin + nanoseconds(event.at("dur")), event.dump()});
        }
    std::vector<std::string> dropped;
    for (auto& [track, slices] : tracks) {
        std::stable_sort(slices.begin(), slices.end(),
                         [](Slice const& a, Slice const& b) { return a.begin < b.begin; });
        std::vector<Slice> open;
        for (Slice const& slice : slices) {
            while (!open.empty() && open.back().end <= slice.begin)
                open.pop_back();
            if (!open.empty() && slice.end > open.back().end)
                dropped.push_back(slice.text);
            else
                open.push_back(slice);
        }
    }
    return dropped;
}

std::size_t count_of(nlohmann::json const& timeline, char const* key, std::string const& value) {
    std::size_t count = 0;
    for (auto const& event : timeline.at("traceEvents"))
        count += event.value(key, "") == value ? 1U : 0U;
    return count;
}

/// The number in "FILE: about N MB", in bytes.
double announced_bytes(std::string const& output, std::string const& file) {
    std::string const mark = file + ": about ";
    std::istringstream words(output.substr(output.find(mark) + mark.size()));
    double number = 0;
    std::string unit;
    words >> number >> unit;
    return number * (unit == "kB" ? 1e3 : unit == "MB" ? 1e6 : 1e9);
}

TEST_CASE("Perfetto drops no slice of a timeline", "[timeline]") {
    for (std::string const config : {"faster_zcu102.yaml", "faster_zcu102_memory.yaml", "architectures/next.yaml"}) {
        CAPTURE(config);
        Waves const waves(config);
        require_done(waves.run(
            "edge_heavy", {"--timeline", "t.json", "--timeline-samples", "9", "--set", "accelerator.clock_mhz=170"}));
        auto const timeline = nlohmann::json::parse(waves.text("t.json"));
        CHECK(dropped_slices(timeline).empty());
        for (auto const& slice : timeline.at("traceEvents"))
            if (slice.at("ph") == "X")
                REQUIRE(slice.at("args").at("begin_cycle") <= slice.at("args").at("end_cycle"));
        CHECK(count_of(timeline, "cat", "sample") == 5);
        bool const has_memory = config == "faster_zcu102_memory.yaml";
        CHECK((count_of(timeline, "name", "busy") > 10) == has_memory);
        CHECK((count_of(timeline, "name", "port 1 waiting") > 10) == has_memory);
    }
}

TEST_CASE("An FST holds what the VCD holds", "[vcd][fst]") {
    Waves const waves("faster_zcu102_memory.yaml");
    for (Words const& window : {Words{}, Words{"--vcd-from", "700", "--vcd-to", "1900"}}) {
        Words options{"--vcd", "a.vcd", "--fst", "b.fst"};
        options.insert(options.end(), window.begin(), window.end());
        require_done(waves.run("one_triangle", options));
        Vcd const vcd = waves.vcd("a.vcd");
        Vcd const fst = read_fst(waves.path() / "b.fst", 5);
        REQUIRE(fst.signals.size() == vcd.signals.size());
        std::uint64_t const end = vcd.signals.at("clock").back().cycle;
        for (auto const& [signal, values] : vcd.signals) {
            CAPTURE(signal);
            CHECK(fst.within(signal, values.front().cycle, end) == vcd.within(signal, values.front().cycle, end));
        }
    }
    // Names of values are in the FST itself.
    CHECK(waves.text("b.gtkw").find("@100000028\naccelerator.core_0.rasterizer.state[7:0]\n") != std::string::npos);
    CHECK_FALSE(waves.has("b.states.txt"));
}

TEST_CASE("A save file names files beside it, and groups end as they begin", "[vcd]") {
    Waves const waves;
    require_done(waves.run("one_triangle", {"--vcd", "a.vcd"}));
    std::vector<std::string> const lines = lines_of(waves.text("a.gtkw"));
    CHECK(waves.text("a.gtkw").find(waves.path().string()) == std::string::npos);
    CHECK(std::count(lines.begin(), lines.end(), "^1 a.command_command.txt") == 4);  // written and read, of two cores
    CHECK(waves.text("a.edge_token_kind.txt") == "0 edge\n1 object\n2 end\n");
    auto const count = [&lines](char const* flags) { return std::count(lines.begin(), lines.end(), flags); };
    CHECK(count("@c00200") > 10);
    CHECK(count("@c00200") == count("@1401200"));
    CHECK(count("@800200") == count("@1000200"));
}

TEST_CASE("The memory's ports in a waveform carry what the run reports", "[vcd][memory]") {
    Waves const waves("faster_zcu102_memory.yaml");
    require_done(waves.run("edge_heavy", {"--vcd", "a.vcd", "--out", "out"}));
    Vcd const vcd = waves.vcd("a.vcd");
    auto const memory = nlohmann::json::parse(waves.text("out/summary.json")).at("external_memory");
    std::uint64_t bytes = 0;
    for (std::size_t port = 0; port < 3; ++port) {
        std::string const path = "memory.port_" + std::to_string(port);
        bytes += vcd.largest(path + ".bytes");
        CHECK(vcd.duration(path + ".busy", 1) == memory.at("ports").at(port).at("beats").get<std::uint64_t>());
    }
    CHECK(vcd.largest("memory.controller.queue") <= memory.at("controller").at("largest_queue").get<std::uint64_t>());
    CHECK(bytes <= memory.at("bytes").get<std::uint64_t>());  // writes under way in the end are not waited for
    CHECK(bytes + 3 * 32 >= memory.at("bytes").get<std::uint64_t>());
}

TEST_CASE("A whole waveform says beforehand how large it will be", "[vcd][fst]") {
    Waves const waves;
    CommandResult const result = waves.run("edge_heavy", {"--vcd", "a.vcd", "--fst", "a.fst"});
    require_done(result);
    for (std::string const file : {"a.vcd", "a.fst"}) {
        CAPTURE(file, result.out);
        auto const bytes = static_cast<double>(std::filesystem::file_size(waves.path() / file));
        CHECK(announced_bytes(result.out, file) > bytes / 2);
        CHECK(announced_bytes(result.out, file) < bytes * 2);
    }
    for (Words const& window : {Words{"--vcd-samples", "1-2"}, Words{"--vcd-samples", "1"},
                                Words{"--vcd-from", "1000", "--vcd-to", "250000"}}) {
        Words words{"--vcd", "b.vcd"};
        words.insert(words.end(), window.begin(), window.end());
        CommandResult const part = waves.run("edge_heavy", words);
        auto const bytes = static_cast<double>(std::filesystem::file_size(waves.path() / "b.vcd"));
        CAPTURE(window, bytes, part.out);
        CHECK(announced_bytes(part.out, "b.vcd") > bytes / 2);
        CHECK(announced_bytes(part.out, "b.vcd") < bytes * 2);
    }
    CHECK(waves.run("edge_heavy", {"--vcd", "b.vcd", "--vcd-to", "50"}).out.find("about") == std::string::npos);
}

TEST_CASE("Lists that are none are refused, and say that they may be lists", "[vcd]") {
    TempFolder const folder;
    for (Words const& words :
         {Words{"--vcd", "a.vcd", "--vcd-cores", "a"}, Words{"--vcd", "a.vcd", "--vcd-cores", "0,10"},
          Words{"--report", "a.html", "--report-samples", "0-2,620"}}) {
        Words all{"run", FASTER_SOURCE_DIR "/configs/faster_zcu102.yaml", "--set", "workload.samples.count=20"};
        all.insert(all.end(), words.begin(), words.end());
        check_bad_input(run_command(FASTER_SIM_BINARY, all, folder.path()),
                        {words[2] + " ", ": expected a number, or several such as 0,2-4, within 0-"});
    }
}

TEST_CASE("A waveform of more than 2 GB has to be forced", "[vcd]") {
    TempFolder const folder;
    auto const result_of = [&](Words words) {
        words.insert(words.begin(), {"run", FASTER_SOURCE_DIR "/configs/faster_zcu102.yaml", "--set",
                                     "workload.samples.count=150", "--vcd", "a.vcd"});
        return run_command(FASTER_SIM_BINARY, words, folder.path());
    };
    check_bad_input(result_of({"--vcd-modules", "inlier_unit"}), {"--vcd a.vcd", "GB", "--vcd-samples", "--force"});
    CHECK_FALSE(std::filesystem::exists(folder / "a.vcd"));
    for (Words const& window : {Words{"--vcd-samples", "10-140"}, Words{"--vcd-to", "18446744073709551615"}}) {
        Words words{"--fst", "a.fst"};
        words.insert(words.end(), window.begin(), window.end());
        check_bad_input(result_of(words), {"--vcd a.vcd", "GB", "--force"});
    }
}

TEST_CASE("A run that gets stuck still leaves its waveform", "[vcd]") {
    Waves const waves;
    CommandResult const result =
        waves.run("one_triangle", {"--vcd", "a.vcd", "--set", "accelerator.fifos.fragment_index.depth=1"});
    CHECK(result.exit_code == 3);
    Vcd const vcd = waves.vcd("a.vcd");
    CHECK(vcd.duration("core_0.fifo_fragment_index.full", 1) > 0);
}

TEST_CASE("A waveform of what comes after the run is empty, and that is said", "[vcd]") {
    Waves const waves;
    CommandResult const result = waves.run("one_triangle", {"--vcd", "a.vcd", "--vcd-from", "999999"});
    CHECK(result.exit_code == 0);
    CHECK_THAT(result.err, Catch::Contains("warning: --vcd-from 999999: the run ends before"));
    check_bad_input(waves.run("one_triangle", {"--vcd", "a.vcd", "--vcd-from", "1e3"}),
                    {"--vcd-from: 1e3, expected a cycle, 0 or more"});
}

TEST_CASE("Waveform options that make no sense are refused", "[vcd]") {
    Waves const waves;
    auto const refused = [&](Words const& more, Words const& parts) {
        check_bad_input(waves.run("one_triangle", more), parts);
        CHECK_FALSE(waves.has("a.vcd"));
    };
    refused({"--vcd-cores", "0"}, {"--vcd-cores", "--vcd"});
    refused({"--vcd", "a.vcd", "--vcd-cores", "0-2"}, {"--vcd-cores 0-2", "within 0-1"});
    refused({"--vcd", "a.vcd", "--vcd-samples", "1"}, {"--vcd-samples 1", "within 0-0"});
    refused({"--vcd", "a.vcd", "--vcd-samples", "0", "--vcd-cores", "1"},
            {"--vcd-cores 1", "--vcd-samples 0", "expected core 0"});
    refused({"--vcd", "a.vcd", "--vcd-samples", "x"}, {"--vcd-samples x"});
    refused({"--vcd", "a.vcd", "--vcd-samples", "0", "--vcd-from", "1"}, {"--vcd-samples", "--vcd-from"});
    refused({"--vcd", "a.vcd", "--vcd-from", "9", "--vcd-to", "8"}, {"--vcd-to 8", "--vcd-from 9"});
    refused({"--vcd", "a.vcd", "--vcd-from", "-1"}, {"--vcd-from", "-1"});
    refused({"--vcd", "a.vcd", "--vcd-to", "-5"}, {"--vcd-to", "-5"});
    refused({"--vcd", "a.vcd", "--vcd-modules", "inlier_unti"}, {"inlier_unti", "inlier_unit"});
    refused({"--vcd", "/proc/nowhere/a.vcd"}, {"nowhere/a.vcd", "cannot be written"});
    refused({"--timeline", "/proc/nowhere/t.json"}, {"nowhere/t.json", "cannot be written"});
    refused({"--timeline", "t.json", "--timeline-samples", "0"}, {"--timeline-samples"});
}

}  // namespace waveform_test
