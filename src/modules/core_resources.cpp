#include "modules/core_resources.hpp"

#include <algorithm>

#include "faster/sweep_design.hpp"
#include "faster/synthesized_units.hpp"
#include "kernel/machine/machine_resources.hpp"
#include "modules/counted_resources.hpp"
#include "modules/raster_core_description.hpp"

namespace faster {

namespace {

/// Thesis, Table 6.2: FASTER on ten cores.
constexpr Resources thesis_chip{212371, 193509, 654, 414};
constexpr double thesis_cores = 10;

using UnitKeys = std::vector<UnitKey>;

template <class Number> UnitKey number(char const* name, Number value, int standard) {
    return {name, std::to_string(value), std::to_string(standard)};
}
UnitKey choice(char const* name, bool holds, char const* value) { return {name, holds ? value : "", ""}; }

/// Of a unit of the twin: what it takes, and its longest paths.
struct Logic {
    ResourceParts parts;
    std::vector<UnitPath> paths;
};

/// Without its memories, which are counted for themselves.
Logic logic(char const* unit, UnitKeys const& keys) {
    ResourcePart part = synthesized_units().unit(unit, keys);
    part.amount.ramb36 = 0;
    return {{part}, synthesized_paths().paths(unit, differing_keys(keys))};
}

/// Longest paths of a unit with so many lanes, or with more where none has as many.
std::vector<UnitPath> paths_with_lanes(char const* unit, int lanes) {
    if (lanes == 1)
        return synthesized_paths().paths(unit, {});
    char const* const built = lanes <= 2 ? "2" : lanes <= 5 ? "5" : "10";
    return synthesized_paths().paths(unit, {{"lanes", built}});
}

/// With those besides its own.
Logic with_paths(Logic logic, std::vector<UnitPath> const& more) {
    logic.paths.insert(logic.paths.end(), more.begin(), more.end());
    return logic;
}

/// Stages of a delay line more or fewer than the unit was synthesized with.
struct Delay {
    Cycles stages;
    Cycles standard;
    double bits;
};

ResourceParts delays(std::vector<Delay> const& lines) {
    auto const cost = [](Cycles stages, double bits) {
        auto const at = static_cast<double>(stages);
        return stages == 0 ? Resources{} : synthesized_units().on_grid("delay_line", "stages", at, "bits", bits).amount;
    };
    ResourceParts parts;
    for (Delay const& line : lines)
        if (line.stages != line.standard)
            parts.push_back(
                {"stages", cost(line.stages, line.bits) - cost(line.standard, line.bits), ResourceBasis::interpolated});
    return parts.empty() ? parts : ResourceParts{sum_of("stages", parts)};
}

class CoreCount {
  public:
    CoreCount(AcceleratorConfig const& config, Machine const& machine) : config_(config), machine_(machine) {
        told_.modules.resize(machine.processes.size());
        told_.paths.resize(machine.processes.size());
        add("sample_dispatcher", logic("sample_dispatcher", {}));
        add("vertex_transform", logic("vertex_transform", {number("write_latency", latency("vertex"), 40)}),
            counted_in_vertex_transform(config));
        add("rasterizer", rasterizer(),
            delays({{latency("command"), 7, 1},
                    {latency("fragment_depth"), 7, 49},
                    {latency("fragment_index"), 7, 33},
                    {latency("edge_token"), 7, 35}}),
            counted_in_rasterizer(config));
        add("area_reciprocal", area_reciprocal());
        add("edge_map_builder", edge_map_builder(), delays({{latency("edge_map"), 2, 2}}),
            counted_in_edge_map_builder(config, machine));
        add("observation_reader", observation_reader(),
            delays({{latency("observed_depth"), 4, 12}, {latency("observed_edge"), 4, 2}}),
            counted_in_observation_reader(config));
        add("inlier_unit", inlier_unit(), delays({{fragment_read_stage(), 7, 37}}),
            counted_in_inlier_unit(config, machine));
        add("result_collector", logic("result_collector", {}));
        add("edge_map_output", {}, counted_in_read_out());
        add("inlier_sweep", {}, counted_in_read_out());
        for (MachineFifo const& fifo : machine.fifos)
            told_.fifos.push_back(fifo.is_present ? synthesized_units().fifo(fifo.kind, fifo.tokens(), fifo.bits)
                                                  : ResourcePart{});
    }

    ToldResources told() && { return std::move(told_); }

  private:
    template <class... More> void add(char const* module, Logic unit, More const&... more) {
        (unit.parts.insert(unit.parts.end(), more.begin(), more.end()), ...);
        std::size_t const number = machine_.process(module);
        if (!machine_.processes[number].is_present)
            return;
        told_.modules[number] = std::move(unit.parts);
        told_.paths[number] = std::move(unit.paths);
    }

    Cycles latency(char const* fifo) const { return machine_.fifos[machine_.fifo(fifo)].write_latency; }
    /// Of the depth buffer, as the twin has it: the eighth of ten stages, or the last but two.
    Cycles fragment_read_stage() const {
        Cycles const depth = machine_.loops[machine_.loop(machine_.process("inlier_unit"), "fragment")].depth;
        return std::clamp<Cycles>(depth, 3, 10) - 3;
    }
    Logic with_sweep_lanes(char const* unit, Logic one_lane) const {
        int const lanes = config_.inlier_unit.sweep_lanes;
        return lanes > 1 ? with_paths(std::move(one_lane), paths_with_lanes(unit, lanes)) : one_lane;
    }
    UnitKey window() const { return number("window", config_.window, 200); }
    UnitKey vertex_xy() const { return number("vertex_xy", config_.fraction_bits.vertex_xy, 4); }
    UnitKey reciprocal_bits() const { return number("area_reciprocal", config_.fraction_bits.area_reciprocal, 30); }

    Logic rasterizer() const {
        bool const object_only =
            config_.rasterizer.edge_tokens == EdgeTokens::object || config_.flow == Flow::fpga_grip;
        Logic scan = logic("rasterizer", {window(), vertex_xy(), choice("edge_tokens", object_only, "object")});
        if (config_.rasterizer.scan != ScanPolicy::spans)
            return scan;
        return with_paths(std::move(scan), paths_with_lanes("span_scan", config_.rasterizer.lanes));
    }
    Logic area_reciprocal() const {
        MachineFifo const& fifo = machine_.fifos[machine_.fifo("area_reciprocal")];
        return logic(
            "area_reciprocal",
            {vertex_xy(), reciprocal_bits(), number("write_latency", fifo.write_latency, 36),
             number("interval", machine_.processes[machine_.process("area_reciprocal")].numbers.at("interval"), 1),
             choice("when_full", fifo.when_full == WhenFull::squeeze, "squeeze")});
    }
    Logic edge_map_builder() const {
        EdgeMapConfig const& map = config_.edge_map;
        return with_sweep_lanes(
            "lane_map_output",
            logic("edge_map_builder",
                  {window(), choice("algorithm", map.algorithm == EdgeMapAlgorithm::inner_border, "inner_border"),
                   choice("clearing", map.clearing == MapClearing::on_read_out, "on_read_out"),
                   choice("flush_last", map.flush_last, "true")}));
    }
    Logic observation_reader() const {
        return with_sweep_lanes("lane_observation_reader", logic("observation_reader", {window()}));
    }
    Logic inlier_unit() const {
        InlierUnitConfig const& unit = config_.inlier_unit;
        bool const own_depth = contour_has_depth(config_);
        bool const has_lines = !own_depth && unit.neighbour_access == NeighbourAccess::window;
        return with_sweep_lanes(
            "lane_sweep",
            logic("inlier_unit", {window(), vertex_xy(), reciprocal_bits(),
                                  number("ports", machine_.memories[machine_.memory("depth_buffer")].ports, 2),
                                  number("fragment_depth", config_.fraction_bits.fragment_depth, 18),
                                  choice("algorithm", own_depth, "inner_border"),
                                  choice("clearing", unit.clearing == MapClearing::on_read_out, "on_read_out"),
                                  choice("fragment_loop", unit.fragment_loop == FragmentLoop::flattened, "flattened"),
                                  choice("neighbour_access", has_lines, "window")}));
    }

    AcceleratorConfig const& config_;
    Machine const& machine_;
    ToldResources told_;
};

/// Of each core: what Table 6.2 has more than ten cores of the default design.
Resources beside_a_core() {
    static Resources const share = [] {
        AcceleratorConfig const standard;
        Machine machine = make_machine(describe_raster_core(standard), standard);
        machine.resources = std::make_shared<TellResources const>(
            [&standard](Machine const& of) { return CoreCount(standard, of).told(); });
        return 1 / thesis_cores * thesis_chip - resources_of(machine).core.amount;
    }();
    return share;
}

}  // namespace

ToldResources core_resources(AcceleratorConfig const& config, Machine const& machine) {
    ToldResources told = CoreCount(config, machine).told();
    told.beside = beside_a_core();
    told.beside_is =
        "what the thesis's chip has (Table 6.2) and ten synthesized cores of the default design do not: AXI, DMA, the "
        "host interface, the vertex transform's arithmetic; a tenth of it for each core";
    return told;
}

}  // namespace faster
