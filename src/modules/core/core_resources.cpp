#include "modules/core/core_resources.hpp"

#include <algorithm>

#include "dataflow/tools/resources/machine_resources.hpp"
#include "faster/config/lane_design.hpp"
#include "faster/config/sweep_design.hpp"
#include "faster/config/synthesized_units.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/counted_resources.hpp"
#include "modules/core/lane_resources.hpp"
#include "modules/core/raster_core_description.hpp"
#include "modules/core/unit_logic.hpp"

namespace faster {

namespace {

/// Thesis, Table 6.2: FASTER on ten cores.
constexpr Resources thesis_chip{212371, 193509, 654, 414};
constexpr double thesis_cores = 10;

/// The default design, with whose latencies the units were synthesized.
Machine const& standard_machine() {
    static Machine const machine = [] {
        AcceleratorConfig const standard;
        return make_machine(describe_raster_core(standard), standard);
    }();
    return machine;
}

Cycles latency_of(Machine const& machine, char const* fifo) { return machine.fifos[machine.fifo(fifo)].write_latency; }
MachineLoop const& fragment_loop_of(Machine const& machine) {
    return machine.loops[machine.loop(machine.process("inlier_unit"), "fragment")];
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
        add("sample_dispatcher", synthesized_logic("sample_dispatcher", {}));
        add("vertex_transform", synthesized_logic("vertex_transform", {write_latency("vertex")}),
            counted_in_vertex_transform(config));
        add("area_reciprocal", area_reciprocal());
        if (has_lane_core(config))
            add_lane_units();
        else
            add_thesis_units();
        add("result_collector", synthesized_logic("result_collector", {}));
        for (MachineFifo const& fifo : machine.fifos)
            told_.fifos.push_back(fifo.is_present ? synthesized_units().fifo(fifo.kind, fifo.tokens(), fifo.bits)
                                                  : ResourcePart{});
    }

    ToldResources told() && { return std::move(told_); }

  private:
    template <class... More> void add(char const* module, UnitLogic unit, More const&... more) {
        (unit.parts.insert(unit.parts.end(), more.begin(), more.end()), ...);
        std::size_t const number = machine_.process(module);
        if (!machine_.processes[number].is_present)
            return;
        told_.modules[number] = std::move(unit.parts);
        told_.paths[number] = std::move(unit.paths);
    }

    void add_thesis_units() {
        add("rasterizer", rasterizer(),
            delays({delay("command", 1), delay("fragment_depth", 49), delay("fragment_index", 33),
                    delay("edge_token", 35)}),
            counted_in_rasterizer(config_));
        add("edge_map_builder", edge_map_builder(), delays({delay("edge_map", 2)}),
            counted_in_edge_map_builder(config_, machine_));
        add("observation_reader", observation_reader(),
            delays({delay("observed_depth", 12), delay("observed_edge", 2)}), counted_in_observation_reader(config_));
        add("inlier_unit", inlier_unit(), delays({fragment_read_delay(37)}), counted_in_inlier_unit(config_, machine_));
        add("edge_map_output", {}, counted_in_read_out());
        add("inlier_sweep", {}, counted_in_read_out());
    }
    void add_lane_units() {
        double const lanes = config_.rasterizer.lanes, sweep_lanes = config_.inlier_unit.sweep_lanes;
        add("rasterizer", lane_rasterizer_logic(config_),
            delays({delay("command", 2), delay("fragment_depth", 97), delay("fragment_index", 33 + lanes),
                    delay("edge_token", 33 + lanes)}));
        ResourceParts const output_delays = delays({delay("edge_map", 1 + sweep_lanes)});
        add("edge_map_builder", lane_map_builder_logic(config_, machine_), output_delays);
        add("edge_map_output", lane_map_output_logic(config_), output_delays);
        add("observation_reader", lane_observation_logic(config_),
            delays({delay("observed_depth", 1 + 11 * sweep_lanes), delay("observed_edge", 1 + sweep_lanes)}));
        add("inlier_unit", lane_inlier_logic(config_, machine_), delays({fragment_read_delay(18 + 21 * lanes)}));
        add("inlier_sweep", lane_sweep_logic(config_));
    }

    UnitKey write_latency(char const* fifo) const {
        return number_key("write_latency", latency_of(machine_, fifo),
                          static_cast<int>(latency_of(standard_machine(), fifo)));
    }
    Delay delay(char const* fifo, double bits) const {
        return {latency_of(machine_, fifo), latency_of(standard_machine(), fifo), bits};
    }
    /// Of the depth buffer's read, as the twin has it: in a pipeline that is too short so many stages before its end.
    Delay fragment_read_delay(double bits) const {
        MachineLoop const& standard = fragment_loop_of(standard_machine());
        Cycles const read = standard.dependences.front().read_stage;
        Cycles const behind = standard.depth - read;
        return {std::clamp(fragment_loop_of(machine_).depth, behind, standard.depth) - behind, read, bits};
    }
    UnitLogic with_sweep_lanes(char const* unit, UnitLogic one_lane) const {
        int const lanes = config_.inlier_unit.sweep_lanes;
        if (lanes > 1)
            one_lane += {{}, paths_with_lanes(unit, lanes)};
        return one_lane;
    }
    UnitKey window() const { return number_key("window", config_.window, 200); }
    UnitKey vertex_xy() const { return number_key("vertex_xy", config_.fraction_bits.vertex_xy, 4); }
    UnitKey reciprocal_bits() const { return number_key("area_reciprocal", config_.fraction_bits.area_reciprocal, 30); }

    UnitLogic rasterizer() const {
        bool const object_only =
            config_.rasterizer.edge_tokens == EdgeTokens::object || config_.flow == Flow::fpga_grip;
        UnitLogic scan =
            synthesized_logic("rasterizer", {window(), vertex_xy(), choice_key("edge_tokens", object_only, "object")});
        if (config_.rasterizer.scan == ScanPolicy::spans)
            for (char const* unit : {"span_rows", "span_scan"})
                scan += {{}, paths_with_lanes(unit, config_.rasterizer.lanes)};
        return scan;
    }
    UnitLogic area_reciprocal() const {
        MachineFifo const& fifo = machine_.fifos[machine_.fifo("area_reciprocal")];
        return synthesized_logic(
            "area_reciprocal",
            {vertex_xy(), reciprocal_bits(), write_latency("area_reciprocal"),
             number_key("interval", machine_.processes[machine_.process("area_reciprocal")].numbers.at("interval"), 1),
             choice_key("when_full", fifo.when_full == WhenFull::squeeze, "squeeze")});
    }
    UnitLogic edge_map_builder() const {
        EdgeMapConfig const& map = config_.edge_map;
        return with_sweep_lanes(
            "lane_map_output",
            synthesized_logic(
                "edge_map_builder",
                {window(), choice_key("algorithm", map.algorithm == EdgeMapAlgorithm::inner_border, "inner_border"),
                 choice_key("clearing", map.clearing == MapClearing::on_read_out, "on_read_out"),
                 choice_key("flush_last", map.flush_last, "true")}));
    }
    UnitLogic observation_reader() const {
        return with_sweep_lanes("lane_observation_reader", synthesized_logic("observation_reader", {window()}));
    }
    UnitLogic inlier_unit() const {
        InlierUnitConfig const& unit = config_.inlier_unit;
        bool const own_depth = contour_has_depth(config_);
        bool const has_lines = !own_depth && unit.neighbour_access == NeighbourAccess::window;
        UnitLogic logic = with_sweep_lanes(
            "lane_sweep",
            synthesized_logic("inlier_unit",
                              {window(), vertex_xy(), reciprocal_bits(),
                               number_key("ports", machine_.memories[machine_.memory("depth_buffer")].ports, 2),
                               number_key("fragment_depth", config_.fraction_bits.fragment_depth, 18),
                               choice_key("algorithm", own_depth, "inner_border"),
                               choice_key("clearing", unit.clearing == MapClearing::on_read_out, "on_read_out"),
                               choice_key("fragment_loop", unit.fragment_loop == FragmentLoop::flattened, "flattened"),
                               choice_key("neighbour_access", has_lines, "window")}));
        if (counts_hidden(config_.inlier_unit))
            logic += unit.sweep_lanes > 1
                         ? synthesized_logic("lane_hidden_pixels", {number_key("lanes", unit.sweep_lanes, 1)})
                         : synthesized_logic("hidden_pixels", {});
        return logic;
    }

    AcceleratorConfig const& config_;
    Machine const& machine_;
    ToldResources told_;
};

/// Of each core: what Table 6.2 has more than ten cores of the default design.
Resources beside_a_core() {
    static Resources const share = [] {
        AcceleratorConfig const standard;
        Machine machine = standard_machine();
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
