#include <catch2/catch.hpp>
#include <random>

#include "faster/dataflow_names.hpp"
#include "support/waves.hpp"

namespace waveform_windows_test {

using namespace faster::test;

struct Design {
    std::string config = "faster_zcu102.yaml";
    std::string trace = "edge_heavy";
    Words options;  // also of what is shown
};

/// How often a pixel's neighbours are read, whose buffer it is and what is cleared where: all that decides addresses.
Words with(Words const& settings, Words options = {}) {
    for (std::string const& setting : settings)
        options.insert(options.end(), {"--set", "accelerator." + setting});
    return options;
}

Words deep_fifos() {
    Words settings{"inlier_unit.sweep_region=touched", "edge_map.buffers=2", "inlier_unit.buffers=2"};
    for (char const* const fifo :
         {"sample_vertex",   "sample_raster",  "sample_observation", "vertex",         "area",
          "area_reciprocal", "command",        "fragment_depth",     "fragment_index", "edge_token",
          "edge_map",        "observed_depth", "observed_edge",      "result",         "region",
          "valid_depth",     "map_full",       "map_free",           "depth_full",     "depth_free"})
        settings.push_back("fifos." + std::string(fifo) + ".depth=4096");
    return settings;
}

std::vector<Design> const designs{
    {"faster_zcu102.yaml", "edge_heavy", with({"raster_cores=1"})},
    {"faster_zcu102.yaml", "one_triangle", {}},
    {"faster_zcu102.yaml", "edge_heavy", with(deep_fifos())},
    {"faster_zcu102_memory.yaml", "edge_heavy", with({"memory.prefetch=true", "raster_cores=3"})},
    {"faster_zcu102_memory.yaml", "edge_heavy", with({}, {"--vcd-cores", "1", "--vcd-modules", "inlier*,memory"})},
    {"architectures/next_zcu102.yaml", "edge_heavy", {}},
    {"architectures/next_double_buffers.yaml", "edge_heavy", with({}, {"--vcd-modules", "edge*,depth*"})},
    {"architectures/fpga_grip.yaml", "edge_heavy", {}},
};

struct Window {
    std::uint64_t from = 0;
    std::uint64_t to = 0;
};

class Windows {
  public:
    explicit Windows(Design const& design) : design_(design), waves_(design.config) {}

    Vcd whole() const {
        run("lockstep", "whole.vcd", {"--out", "out"});
        return waves_.vcd("whole.vcd");
    }
    std::vector<Waves::Row> samples() const { return waves_.table("out/samples.csv"); }
    /// Of both engines, which are to write the same bytes.
    Vcd part(Words const& window) const {
        for (std::string const engine : {"lockstep", "decoupled"})
            run(engine, engine + ".vcd", window);
        CHECK(waves_.text("lockstep.vcd") == waves_.text("decoupled.vcd"));
        return waves_.vcd("decoupled.vcd");
    }

  private:
    void run(std::string const& engine, std::string const& file, Words more) const {
        more.insert(more.end(), {"--vcd", file, "--set", "simulation.engine=" + engine});
        more.insert(more.end(), design_.options.begin(), design_.options.end());
        require_done(waves_.run(design_.trace, more));
    }

    Design design_;
    Waves waves_;
};

std::uint64_t end_of(Vcd const& vcd) { return vcd.signals.at("clock").back().cycle; }

void check_window(Vcd const& whole, Vcd const& part, Window window) {
    CAPTURE(window.from, window.to);
    for (auto const& [signal, values] : part.signals) {
        CAPTURE(signal);
        CHECK(part.within(signal, window.from, window.to) == whole.within(signal, window.from, window.to));
    }
}

TEST_CASE("A window shows what the whole waveform shows, from its first cycle on, in both engines", "[vcd]") {
    auto const number = GENERATE(range(std::size_t{0}, std::size_t{8}));
    REQUIRE(designs.size() == 8);
    std::uint64_t const seed = 31 + number;
    CAPTURE(designs[number].config, designs[number].trace, seed);
    Windows const windows(designs[number]);
    Vcd const whole = windows.whole();
    std::mt19937_64 random(seed);
    std::uint64_t const end = end_of(whole);
    for (std::uint64_t const length : {1U, 60U, 300U}) {
        std::uint64_t const from = random() % (end - length);
        Window const window{from, from + length - 1};
        Vcd const part =
            windows.part({"--vcd-from", std::to_string(window.from), "--vcd-to", std::to_string(window.to)});
        CHECK(part.signals.size() == whole.signals.size());
        check_window(whole, part, window);
    }
}

TEST_CASE("Engines write the same bytes where they tell of a cycle in another order", "[vcd]") {
    // What made them do so once: eight cores, ten lanes, deep FIFOs.
    std::vector<std::string> settings{"raster_cores=8",
                                      "rasterizer.lanes=10",
                                      "inlier_unit.sweep_lanes=5",
                                      "brams.object_map.partition.factor=10",
                                      "brams.depth_buffer.partition.factor=10",
                                      "modules.area_reciprocal.interval=1",
                                      "fifos.vertex.depth=16",
                                      "fifos.area.depth=16",
                                      "fifos.area.kind=auto",
                                      "fifos.area_reciprocal.depth=32",
                                      "fifos.edge_token.depth=64"};
    for (std::string const fifo : {"command", "fragment_depth", "fragment_index"}) {
        settings.push_back("fifos." + fifo + ".depth=64");
        settings.push_back("fifos." + fifo + ".kind=auto");
    }
    Windows const windows({"architectures/next_zcu102.yaml", "edge_heavy", with(settings)});
    windows.part({"--vcd-from", "757", "--vcd-to", "1057"});
}

TEST_CASE("A sample's window shows what the whole waveform shows while the sample is scored", "[vcd]") {
    auto const number = GENERATE(std::size_t{0}, std::size_t{2});
    CAPTURE(designs[number].options);
    Windows const windows(designs[number]);
    Vcd const whole = windows.whole();
    auto const samples = windows.samples();
    for (auto const& sample : {samples.front(), samples.back()})
        check_window(whole, windows.part({"--vcd-samples", sample.at("sample"), "--vcd-cores", sample.at("core")}),
                     {std::stoull(sample.at("start_cycle")), std::stoull(sample.at("end_cycle"))});
}

TEST_CASE("Cosimulation leaves waveforms of model and twin, which part where it says", "[vcd]") {
    Waves const waves;
    auto const cosim =
        run_command(FASTER_SIM_BINARY,
                    {"cosim", FASTER_SOURCE_DIR "/traces/one_triangle", "--set", "accelerator.raster_cores=1",
                     "--twin-set", "accelerator.loops.inlier_unit.sweep.ii=4", "--out", "difference"},
                    waves.path());
    if (cosim.err.find("expected a program built with Verilator") != std::string::npos)
        return;
    CHECK(cosim.out.find("core 0, cycle 1083: FIFO edge_map: the model reads, the twin does not\n") == 0);
    CHECK(cosim.out.find("  waveforms of cycles 983 to 1183: difference/cosim_core_0_model.vcd, "
                         "difference/cosim_core_0_twin.vcd\n") != std::string::npos);
    Vcd const model = waves.vcd("difference/cosim_core_0_model.vcd");
    Vcd const twin = waves.vcd("difference/cosim_core_0_twin.vcd");
    REQUIRE(waves.run("one_triangle", {"--set", "accelerator.raster_cores=1", "--vcd", "whole.vcd"}).exit_code == 0);
    Vcd const whole = waves.vcd("whole.vcd");
    REQUIRE(model.signals.size() > 100);
    REQUIRE(model.signals.size() == twin.signals.size());
    for (auto const& [signal, values] : model.signals) {
        CAPTURE(signal);
        CHECK(model.within(signal, 983, 1183) == whole.within(signal, 983, 1183));
        CHECK(model.within(signal, 983, 1082) == twin.within(signal, 983, 1082));
    }
    CHECK(model.at("core_0.fifo_edge_map.read", 1083).bits == 1);
    CHECK(twin.at("core_0.fifo_edge_map.read", 1083).bits == 0);
}

}  // namespace waveform_windows_test
