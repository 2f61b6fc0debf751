#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sstream>

#include "dataflow/run/config/design.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/tools/report/resource_report.hpp"
#include "dataflow/tools/report/timing_report.hpp"
#include "dataflow/tools/resources/machine_resources.hpp"
#include "dataflow/tools/resources/power.hpp"
#include "faster/config/faster_presets.hpp"
#include "faster/config/synthesized_units.hpp"
#include "faster/dataflow_names.hpp"
#include "support/example_run.hpp"
#include "support/temp_folder.hpp"

namespace faster::resources_test {

Machine machine_with(std::vector<std::string> const& overrides) {
    test::TempFolder const folder;
    folder.write("test.yaml", "");
    return machine_of(load_config(folder / "test.yaml", overrides).config);
}

std::string const header = "unit,configuration,lut,ff,dsp,ramb36\n";

ResourceTable const& small_table() {
    static ResourceTable const table(header +
                                     "unit,default,100,50,4,1\n"
                                     "unit,width=8,60,30,2,1\n"
                                     "unit,width=32,160,90,8,2\n"
                                     "unit,kind=other,110,40,4,0\n"
                                     "unit,kind=other width=8,75,20,2,0\n"
                                     "unit,late=true,103,50,4,1\n");
    return table;
}

ResourcePart of_small(std::string const& width, std::string const& kind = "", std::string const& late = "") {
    return small_table().unit("unit", {{"width", width, "16"}, {"kind", kind, ""}, {"late", late, ""}});
}

bool are_equal(Resources const& a, Resources const& b) {
    return a.lut == b.lut && a.ff == b.ff && a.dsp == b.dsp && a.ramb36 == b.ramb36;
}

TEST_CASE("A configuration that was synthesized is its row", "[resources]") {
    CHECK(are_equal(of_small("16").amount, {100, 50, 4, 1}));
    CHECK(are_equal(of_small("8", "other").amount, {75, 20, 2, 0}));
    CHECK(of_small("16").basis == ResourceBasis::synthesized);
    CHECK(of_small("8", "other").basis == ResourceBasis::synthesized);
}

TEST_CASE("A number between two synthesized ones lies on the line between them, and beyond on the last line",
          "[resources]") {
    CHECK(are_equal(of_small("12").amount, {80, 40, 3, 1}));
    CHECK(are_equal(of_small("24").amount, {130, 70, 6, 1.5}));
    CHECK(are_equal(of_small("48").amount, {220, 130, 12, 3}));
    CHECK(are_equal(of_small("4").amount, {40, 20, 1, 1}));
    CHECK(of_small("12").basis == ResourceBasis::interpolated);
}

TEST_CASE("Keys that no row has together add what each changes, to the row that has most of them", "[resources]") {
    CHECK(are_equal(of_small("32", "other").amount, {170, 80, 8, 1}));
    CHECK(are_equal(of_small("8", "other", "true").amount, {78, 20, 2, 0}));
    CHECK(of_small("8", "other", "true").basis == ResourceBasis::interpolated);
    CHECK(are_equal(of_small("16", "unknown").amount, {100, 50, 4, 1}));
    CHECK(of_small("16", "unknown").basis == ResourceBasis::interpolated);
}

TEST_CASE("A grid is interpolated along both keys", "[resources]") {
    ResourceTable const table(header +
                              "fifo,depth=2 bits=1,4,4,0,0\nfifo,depth=2 bits=9,12,20,0,0\n"
                              "fifo,depth=4 bits=1,8,3,0,0\nfifo,depth=4 bits=9,16,3,0,0\n");
    ResourcePart const inside = table.on_grid("fifo", "depth", 3, "bits", 5);
    CHECK(are_equal(inside.amount, {10, 8, 0, 0}));
    CHECK(inside.basis == ResourceBasis::interpolated);
    CHECK(table.on_grid("fifo", "depth", 4, "bits", 9).basis == ResourceBasis::synthesized);
}

TEST_CASE("A table that is none is refused", "[resources]") {
    CHECK_THROWS_AS(ResourceTable("unit,lut\n"), std::invalid_argument);
    CHECK_THROWS_AS(ResourceTable(header + "unit,default,1,2,3\n"), std::invalid_argument);
    CHECK_THROWS_AS(ResourceTable(header + "unit,default,1,2,3,many\n"), std::invalid_argument);
    CHECK_THROWS_AS(ResourceTable(header + "unit,window,1,2,3,4\n"), std::invalid_argument);
    CHECK_THROWS_AS(small_table().unit("none", {}), std::out_of_range);
}

TEST_CASE("The table of the tool is rtl/resources.csv", "[resources]") {
    std::ifstream file(std::string(FASTER_SOURCE_DIR) + "/rtl/resources.csv", std::ios::binary);
    std::ostringstream text;
    text << file.rdbuf();
    REQUIRE(file);
    CHECK(text.str() == synthesized_units_csv);
    std::ifstream timing(std::string(FASTER_SOURCE_DIR) + "/rtl/timing.csv", std::ios::binary);
    std::ostringstream paths;
    paths << timing.rdbuf();
    REQUIRE(timing);
    CHECK(paths.str() == synthesized_paths_csv);
}

TEST_CASE("Interpolation is checked against synthesized points that took no part in it", "[resources]") {
    std::map<std::string, std::string> const standard{{"window", "200"},        {"vertex_xy", "4"},
                                                      {"ports", "2"},           {"area_reciprocal", "30"},
                                                      {"fragment_depth", "18"}, {"interval", "1"}};
    std::map<std::string, std::string> const latencies{{"area_reciprocal", "36"}, {"vertex_transform", "40"}};
    std::size_t points = 0;
    double sum = 0, largest = 0;
    for (ResourceTable::Row const& row : synthesized_units().rows()) {
        if (row.unit.rfind("check.", 0) != 0)
            continue;
        std::string const unit = row.unit.substr(6);
        Resources estimate;
        if (unit.rfind("fifo.", 0) == 0) {
            FifoKind const kind = unit == "fifo.memory" ? FifoKind::memory : FifoKind::shift_register;
            estimate = synthesized_units()
                           .fifo(kind, std::stoull(row.keys.at("depth")),
                                 static_cast<unsigned>(std::stoul(row.keys.at("bits"))))
                           .amount;
        } else {
            std::vector<UnitKey> keys;
            for (auto const& [key, value] : row.keys) {
                auto const by_default = key == "write_latency"    ? latencies.at(unit)
                                        : standard.count(key) > 0 ? standard.at(key)
                                                                  : "";
                keys.push_back({key, value, by_default});
            }
            ResourcePart const part = synthesized_units().unit(unit, keys);
            CHECK(part.basis == ResourceBasis::interpolated);
            estimate = part.amount;
        }
        double const error = std::abs(estimate.lut - row.amount.lut) / std::max(row.amount.lut, 1.0);
        UNSCOPED_INFO(unit << ": LUT " << estimate.lut << " for " << row.amount.lut << ", FF " << estimate.ff << " for "
                           << row.amount.ff << ", DSP " << estimate.dsp << " for " << row.amount.dsp);
        CHECK(std::abs(estimate.dsp - row.amount.dsp) <= 2);
        sum += error;
        largest = std::max(largest, error);
        ++points;
    }
    REQUIRE(points >= 15);
    CHECK(sum / static_cast<double>(points) < 0.10);
    CHECK(largest < 0.30);
}

TEST_CASE("A FIFO deeper than all that were synthesized grows by its structure, from the deepest one on",
          "[resources]") {
    struct Row {
        std::uint64_t tokens;
        unsigned bits;
        double lut, ff;
    };
    // 48 LUTs for every 32 tokens, two for a bit of the count; above 128 tokens 48 for every four inputs of a
    // multiplexer. 256 x 8 is 83 and 9 by Yosys.
    for (Row const& row :
         {Row{64, 48, 105, 7}, Row{65, 48, 153, 7}, Row{96, 48, 153, 7}, Row{97, 48, 201, 7}, Row{512, 48, 831, 10},
          Row{5000, 48, 8229, 13}, Row{100'000, 48, 162'653, 17}, Row{512, 2, 49, 10}, Row{256, 8, 85, 9}}) {
        ResourcePart const fifo = synthesized_units().fifo(FifoKind::shift_register, row.tokens, row.bits);
        INFO(row.tokens << " tokens of " << row.bits << " bits");
        CHECK(are_equal(fifo.amount, {row.lut, row.ff, 0, 0}));
        CHECK(fifo.basis == (row.tokens > 64 ? ResourceBasis::counted : ResourceBasis::interpolated));
    }
    Resources const deep = synthesized_units().fifo(FifoKind::memory, 100'000, 32).amount;  // 131,072 words
    CHECK(deep.ramb36 == 128);
    CHECK(deep.ff == 33 + 3 * 7);  // a count and two addresses of 7 bits more than 1,024 words have
}

TEST_CASE("A machine with a deep shift register takes what that takes", "[resources]") {
    auto const lut_at = [](std::string const& depth) {
        std::string const fifo = "accelerator.fifos.fragment_depth.";
        return resources_of(machine_with({fifo + "kind=shift_register", fifo + "depth=" + depth})).core.amount.lut;
    };
    CHECK(lut_at("512") - lut_at("64") == 831 - 105);
}

TEST_CASE("The default design is synthesized but for its memories", "[resources]") {
    MachineResources const resources = resources_of(machine_of(RunConfig()));
    REQUIRE(resources.modules.size() == 8);
    for (MachineResources::Module const& module : resources.modules) {
        INFO(module.sum.name);
        CHECK(module.sum.basis == ResourceBasis::synthesized);
    }
    for (ResourcePart const& fifo : resources.fifos) {
        INFO(fifo.name);
        CHECK(fifo.basis == ResourceBasis::synthesized);
    }
    CHECK(resources.core.basis == ResourceBasis::counted);  // its memories are
    CHECK(resources.core.amount.ramb36 == 19);
}

TEST_CASE("With what is beside the cores, the default design takes what the thesis prints", "[resources]") {
    Resources const chip = resources_of(machine_of(RunConfig())).chip;
    CHECK(chip.lut == Approx(212371));
    CHECK(chip.ff == Approx(193509));
    CHECK(chip.dsp == Approx(654));
    CHECK(chip.ramb36 == Approx(414));
}

TEST_CASE("Resources of every architecture add up, part by part", "[resources]") {
    for (Preset const& preset : faster_presets()) {
        INFO(preset.name);
        Machine const machine = machine_with({"accelerator.architecture=" + preset.name});
        MachineResources const resources = resources_of(machine);
        Resources sum;
        for (MachineResources::Module const& module : resources.modules) {
            Resources of_parts;
            for (ResourcePart const& part : module.parts) {
                of_parts += part.amount;
                CHECK(module.sum.basis >= part.basis);
            }
            CHECK(are_equal(of_parts, module.sum.amount));
            CHECK(module.sum.amount.ramb36 == 0);
            sum += of_parts;
        }
        for (ResourcePart const& fifo : resources.fifos)
            sum += fifo.amount;
        for (ResourcePart const& memory : resources.memories)
            sum += memory.amount;
        CHECK(sum.lut == Approx(resources.core.amount.lut));
        CHECK(sum.ff == Approx(resources.core.amount.ff));
        CHECK(sum.dsp == Approx(resources.core.amount.dsp));
        CHECK(sum.ramb36 == Approx(resources.core.amount.ramb36));
        CHECK(resources.cores.amount.lut == Approx(static_cast<double>(machine.cores) * sum.lut));
        CHECK(resources.modules.size() == modules_of(machine).size());
    }
}

TEST_CASE("What the twin does not have counts, and says so", "[resources]") {
    auto const module = [](std::vector<std::string> const& overrides, std::string const& name) {
        for (MachineResources::Module const& one : resources_of(machine_with(overrides)).modules)
            if (one.sum.name == name)
                return one.sum;
        return ResourcePart{};
    };
    ResourcePart const one_lane = module({}, "rasterizer");
    ResourcePart const spans = module({"accelerator.rasterizer.scan=spans"}, "rasterizer");
    CHECK(spans.basis == ResourceBasis::synthesized);
    CHECK(spans.amount.lut > one_lane.amount.lut);
    CHECK(module({"accelerator.rasterizer.setup_overlap=4"}, "rasterizer").basis == ResourceBasis::counted);
    ResourcePart const late = module({"accelerator.fifos.fragment_depth.write_latency=6"}, "rasterizer");
    CHECK(late.basis == ResourceBasis::interpolated);
}

TEST_CASE("A design that tells nothing has its FIFOs and memories counted", "[resources]") {
    Machine machine = machine_of(RunConfig());
    machine.resources = nullptr;
    MachineResources const resources = resources_of(machine);
    CHECK(resources.modules.empty());
    CHECK(resources.beside_is.empty());
    CHECK(resources.fifos.size() == 14);
    CHECK(resources.core.amount.lut > 0);
    CHECK(resources.core.amount.ramb36 == 19);
    CHECK(resources.fits(xczu9eg));
    machine.cores = 100;
    CHECK(!resources_of(machine).fits(xczu9eg));  // 1,900 block RAMs
    CHECK(report::resources_text(machine).find("does not fit") != std::string::npos);
}

TEST_CASE("A path is estimated for every synthesized module, and one that is too slow for the clock is named",
          "[timing]") {
    for (MachineResources::Module const& module : resources_of(machine_of(RunConfig())).modules) {
        INFO(module.sum.name);
        if (module.sum.name == "result_collector")
            continue;  // wires
        REQUIRE(module.slowest);
        Estimate const stage = module.slowest->of_stage();
        CHECK(0 < stage.low);
        CHECK(stage.low < stage.typical);
        CHECK(stage.typical < stage.high);
    }
    CHECK(report::timing_text(machine_of(RunConfig())).empty());
    CHECK(report::timing_json(machine_of(RunConfig()))["closes"] == true);
    Machine const fast = machine_with({"accelerator.clock_mhz=300"});
    CHECK(report::timing_json(fast)["closes"] == false);
    std::string const text = report::timing_text(fast);
    CHECK(text.find("At 300 MHz inlier_unit would not close: ") != std::string::npos);
    CHECK(text.find(" ns to counters (") != std::string::npos);  // from a net without a name
    CHECK(text.find("sample_dispatcher") == std::string::npos);
}

TEST_CASE("Modules of our own design are synthesized, but for what lies outside of its core", "[resources]") {
    for (MachineResources::Module const& module :
         resources_of(machine_with({"accelerator.architecture=next_zcu102"})).modules)
        for (ResourcePart const& part : module.parts) {
            INFO(module.sum.name << ": " << part.name);
            bool const is_outside = part.name.find("mesh") == 0 || part.name.find("four words") == 0;
            CHECK((part.basis == ResourceBasis::synthesized) != is_outside);
        }
}

TEST_CASE("Our own design leaves a fifth of every resource, and with a core more it would not", "[resources]") {
    Resources const device{274080, 548160, 2520, 912};
    Resources const chip = resources_of(machine_with({"accelerator.architecture=next_zcu102"})).chip;
    CHECK(chip.lut <= 0.8 * device.lut);
    CHECK(chip.ff <= 0.8 * device.ff);
    CHECK(chip.dsp <= 0.8 * device.dsp);
    CHECK(chip.ramb36 <= 0.8 * device.ramb36);
    CHECK(resources_of(machine_with({"accelerator.architecture=next_zcu102", "accelerator.raster_cores=8"})).chip.lut >
          0.8 * device.lut);
}

TEST_CASE("Lanes and spans have the longest paths of their own units", "[timing]") {
    Machine const next = machine_with({"accelerator.architecture=next_zcu102"});
    CHECK(report::timing_text(next).empty());
    Machine const next_with_five_lanes = machine_with({"accelerator.architecture=next"});
    CHECK(report::timing_text(next_with_five_lanes).find("At 200 MHz rasterizer would not close: ") !=
          std::string::npos);
    Machine const plain = machine_with({"accelerator.edge_map.algorithm=inner_border"});
    auto const slowest = [](Machine const& machine, char const* module) {
        return resources_of(machine).modules.at(machine.process(module)).slowest->of_stage().typical;
    };
    CHECK(slowest(next, "rasterizer") > slowest(plain, "rasterizer"));
    CHECK(slowest(next, "inlier_unit") != slowest(plain, "inlier_unit"));
}

TEST_CASE("Power adds up, and energy is power times the time of the run", "[power]") {
    RunStatistics run = test::example_run();
    PowerCoefficients coefficients;
    RunPower const power = power_of(run, coefficients);
    double milliwatts =
        power.fifos.milliwatts.typical + power.memories.milliwatts.typical + power.beside.milliwatts.typical;
    for (PowerRow const& module : power.modules)
        milliwatts += module.milliwatts.typical;
    CHECK(power.dynamic_w.typical == Approx(milliwatts / 1e3));
    CHECK(power.total_w.typical == Approx(power.dynamic_w.typical + power.static_w.typical + power.ps_w.typical));
    CHECK(power.total_w.low < power.total_w.typical);
    CHECK(power.total_w.typical < power.total_w.high);
    CHECK(power.energy_mj.high == Approx(power.total_w.high * run.machine.milliseconds(run.total_cycles)));
}

TEST_CASE("Each part's power is its activity times its coefficient", "[power]") {
    RunStatistics run = test::example_run();
    run.machine.clock_mhz = 100;
    double bits = 0, accesses = 0;
    for (CoreStatistics const& core : run.cores) {
        for (std::size_t const i : fifos_of(run.machine))
            bits += static_cast<double>(core.fifos[i].writes) * run.machine.fifos[i].bits;
        for (LoopStatistics const& loop : core.loops)
            accesses += static_cast<double>(loop.iterations * loop.bram_accesses);
    }
    REQUIRE(bits > 0);
    REQUIRE(accesses > 0);
    double const microseconds = static_cast<double>(run.total_cycles) / 100;
    PowerCoefficients only;  // pJ / us = uW
    only = {{}, {}, {}, {0, 2, 0}, {0, 3, 0}, {}, {}};
    RunPower const power = power_of(run, only);
    CHECK(power.fifos.milliwatts.typical == Approx(2e-3 * bits / microseconds));
    CHECK(power.memories.milliwatts.typical == Approx(3e-3 * accesses / microseconds));
    CHECK(power.modules[2].milliwatts.typical == 0);
    only = {{0, 1, 0}, {}, {}, {}, {}, {}, {}};
    std::size_t const rasterizer = run.machine.process("rasterizer");
    double const busy = static_cast<double>(process_sum(run, rasterizer)[CycleClass::busy]);
    REQUIRE(busy > 0);
    double const luts = resources_of(run.machine).modules[2].sum.amount.lut;
    CHECK(power_of(run, only).modules[2].milliwatts.typical == Approx(1e-3 * luts * busy / microseconds));
}

TEST_CASE("Counting hidden pixels takes a unit of its own in the inlier unit, and a wider result",
          "[resources][hidden]") {
    struct Case {
        std::vector<std::string> design;
        char const* unit;
        char const* lanes;
        std::uint64_t more_bits;
    };
    std::vector<std::string> const next{"accelerator.architecture=next_zcu102"};
    for (Case const& one : {Case{{}, "hidden_pixels", "1", 16 + 4 * 8}, Case{next, "lane_hidden_pixels", "6", 48}}) {
        CAPTURE(one.unit);
        Machine const plain = machine_with(one.design);
        std::vector<std::string> counting = one.design;
        counting.emplace_back("accelerator.inlier_unit.hidden=counted");
        Machine const counted = machine_with(counting);
        std::size_t const result = plain.fifo("result");
        CHECK(counted.fifos[result].bits == plain.fifos[result].bits + one.more_bits);
        Resources const unit = synthesized_units().unit(one.unit, {{"lanes", one.lanes, "1"}}).amount;
        auto const fifo = [&](Machine const& machine) {
            MachineFifo const& of = machine.fifos[result];
            return synthesized_units().fifo(of.kind, of.tokens(), of.bits).amount;
        };
        Resources const expected = unit + (fifo(counted) - fifo(plain));
        Resources const more = resources_of(counted).core.amount - resources_of(plain).core.amount;
        CHECK(more.lut == Approx(expected.lut));
        CHECK(more.ff == Approx(expected.ff));
        CHECK(more.ramb36 == 0);
        CHECK(more.lut > 50);
    }
}

}  // namespace faster::resources_test
