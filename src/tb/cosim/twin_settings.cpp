#include "tb/cosim/twin_settings.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::rtl {

namespace {

constexpr std::uint64_t most_cycles = 255;    // of an interval or a depth
constexpr std::uint64_t most_stages = 63;     // of a delay line
constexpr std::uint64_t most_registers = 64;  // places of a FIFO
constexpr std::uint64_t most_memory_words = 1024;
constexpr std::uint64_t most_lane_memory_words = 4094;
constexpr std::uint64_t most_lanes = 10;
constexpr std::uint64_t most_setups_ahead = 31;
constexpr std::uint64_t default_setup_cycles = 12;
// With lanes spans are divided for 18 cycles besides, which the twin knows, and all of it goes through a delay line;
// and its first row takes 6 more.
constexpr std::uint64_t most_lane_setup_cycles = most_stages - 18;
constexpr std::uint64_t least_lane_setup_cycles = 6;
constexpr int largest_window = 255;

/// `found`: the key with its value, or alone.
[[noreturn]] void refuse(std::string const& found, std::string const& expected) {
    throw InputError(
        fmt::format("accelerator.{}: expected {}, the register-transfer twin has nothing else", found, expected));
}

std::uint64_t in_range(std::string const& key, std::uint64_t value, std::uint64_t least, std::uint64_t most) {
    if (value < least || value > most)
        refuse(fmt::format("{} = {}", key, value), fmt::format("{} to {}", least, most));
    return value;
}

void require(bool holds, std::string const& key, std::string const& expected) {
    if (!holds)
        refuse(key, expected);
}

void check_design(AcceleratorConfig const& config, Machine const& machine) {
    require(config.flow == Flow::faster, "flow", "faster");
    require(config.edge_map.algorithm == EdgeMapAlgorithm::dual_map ||
                config.edge_map.algorithm == EdgeMapAlgorithm::inner_border,
            "edge_map.algorithm", "dual_map or inner_border");
    require(config.edge_map.buffers == 1, "edge_map.buffers", "1");
    require(config.inlier_unit.buffers == 1, "inlier_unit.buffers", "1");
    require(config.inlier_unit.sweep_lanes == 1, "inlier_unit.sweep_lanes", "1");
    require(config.inlier_unit.sweep_region == SweepRegion::window, "inlier_unit.sweep_region", "window");
    require(config.rasterizer.scan == ScanPolicy::zigzag, "rasterizer.scan", "zigzag");
    require(config.rasterizer.setup_overlap == 0, "rasterizer.setup_overlap", "0");
    require(config.rasterizer.lanes == 1, "rasterizer.lanes", "1");
    require(!machine.external_memory, "memory.model", "ideal");
    for (MachineMemory const& memory : machine.memories)
        require(memory.partition.banks() <= 1, "brams." + memory.name + ".partition.factor", "1");
    in_range("window", static_cast<std::uint64_t>(config.window), 2, largest_window);
}

/// The twin forwards, or does not: --no-forwarding.
void require_no_interlocks(Machine const& machine) {
    for (MachineLoop const& loop : machine.loops)
        for (MachineDependence const& dependence : loop.dependences)
            if (dependence.interlocks())
                refuse(fmt::format("loops.{}.{}.hazards = interlock", loop.timed_by,
                                   machine.memories[dependence.memory].name),
                       "report or forward");
}

/// Whether it is a design of the twin with lanes, or nearer to one than to the thesis's.
bool wants_lanes(AcceleratorConfig const& config) {
    return config.rasterizer.scan == ScanPolicy::spans || config.rasterizer.setup_overlap > 0 ||
           config.rasterizer.lanes > 1 || config.inlier_unit.sweep_lanes > 1 || config.edge_map.buffers > 1 ||
           config.inlier_unit.buffers > 1 || config.inlier_unit.sweep_region == SweepRegion::touched;
}

/// Banks of columns, of which each lane has its own.
std::uint8_t banks_of(MachineMemory const& memory, AcceleratorConfig const& config) {
    std::string const key = "brams." + memory.name + ".partition";
    PartitionConfig const& partition = config.memory(memory.name).partition;
    std::uint64_t const banks = in_range(key + ".factor", memory.partition.banks(), 1, most_lanes);
    require(banks == 1 || (partition.type == PartitionType::cyclic && partition.dimension == 2), key,
            "cyclic banks of dimension 2");
    for (int const lanes : {config.rasterizer.lanes, config.inlier_unit.sweep_lanes})
        if (banks % static_cast<std::uint64_t>(lanes) != 0)
            refuse(fmt::format("{}.factor = {}", key, banks), fmt::format("a multiple of {} lanes", lanes));
    return static_cast<std::uint8_t>(banks);
}

TwinSettings::Lanes lane_settings(AcceleratorConfig const& config, Machine const& machine) {
    require(config.flow == Flow::faster, "flow", "faster");
    require(config.edge_map.algorithm == EdgeMapAlgorithm::inner_border, "edge_map.algorithm", "inner_border");
    require(config.rasterizer.edge_tokens == EdgeTokens::object, "rasterizer.edge_tokens", "object");
    require(config.rasterizer.scan == ScanPolicy::spans, "rasterizer.scan", "spans");
    require(config.edge_map.clearing == MapClearing::on_read_out, "edge_map.clearing", "on_read_out");
    require(config.inlier_unit.clearing == MapClearing::on_read_out, "inlier_unit.clearing", "on_read_out");
    require(config.inlier_unit.fragment_loop == FragmentLoop::flattened, "inlier_unit.fragment_loop", "flattened");
    require(!machine.external_memory, "memory.model", "ideal");
    in_range("window", static_cast<std::uint64_t>(config.window), 2, largest_window);
    auto const lanes = [](std::string const& key, int value) {
        return static_cast<std::uint8_t>(in_range(key, static_cast<std::uint64_t>(value), 1, most_lanes));
    };
    TwinSettings::Lanes settings;
    settings.scan = lanes("rasterizer.lanes", config.rasterizer.lanes);
    settings.sweep = lanes("inlier_unit.sweep_lanes", config.inlier_unit.sweep_lanes);
    settings.object_map_banks = banks_of(machine.memories[machine.memory("object_map")], config);
    settings.depth_buffer_banks = banks_of(machine.memories[machine.memory("depth_buffer")], config);
    settings.setups_ahead = static_cast<std::uint8_t>(
        in_range("rasterizer.setup_overlap", config.rasterizer.setup_overlap, 1, most_setups_ahead));
    settings.sweeps_touched = config.inlier_unit.sweep_region == SweepRegion::touched;
    settings.has_two_maps = config.edge_map.buffers == 2;
    settings.has_two_depth_buffers = config.inlier_unit.buffers == 2;
    return settings;
}

TwinSettings::Fifo fifo_settings(MachineFifo const& fifo, bool has_lanes) {
    TwinSettings::Fifo settings;
    std::string const key = "fifos." + fifo.name;
    std::uint64_t const most = fifo.kind != FifoKind::memory ? most_registers
                               : has_lanes                   ? most_lane_memory_words
                                                             : most_memory_words;
    settings.kind = static_cast<std::uint8_t>(fifo.configured_kind);
    settings.depth = static_cast<std::uint16_t>(in_range(key + ".depth", fifo.depth, 1, most));
    // The word of the edge map has to be read first; and a result cannot leave before the read of its own step.
    std::uint64_t const least = fifo.name == "edge_map" || fifo.name == "area_reciprocal" ? 1 : 0;
    settings.write_latency =
        static_cast<std::uint8_t>(in_range(key + ".write_latency", fifo.write_latency, least, most_stages));
    return settings;
}

/// Stages that reading a memory, and what comes after, takes at least.
std::uint64_t least_depth(std::string const& loop, AcceleratorConfig const& config, Machine const& machine) {
    if (loop == "edge_map_builder.token")
        return 2;
    if (loop == "edge_map_builder.output")
        return 2;
    if (loop == "inlier_unit.fragment")
        return 3;
    if (loop != "inlier_unit.sweep")
        return 1;
    bool const reads_one = config.edge_map.algorithm == EdgeMapAlgorithm::inner_border ||
                           config.inlier_unit.neighbour_access == NeighbourAccess::window;
    if (reads_one)
        return 2;
    std::uint64_t const ports = machine.memories[machine.memory("depth_buffer")].ports;
    return std::max((5 + ports - 1) / ports + 1, 5 / ports + 1);
}

TwinSettings::Loop loop_settings(MachineLoop const& loop, std::string const& name, std::uint64_t least) {
    TwinSettings::Loop settings;
    std::string const key = "loops." + name;
    settings.target = static_cast<std::uint8_t>(in_range(key + ".ii", loop.interval.target, 1, most_cycles));
    settings.recurrence =
        static_cast<std::uint8_t>(in_range(key + ".recurrence_ii", loop.interval.recurrence, 1, most_cycles));
    settings.depth = static_cast<std::uint8_t>(in_range(key + ".depth", loop.depth, least, most_cycles));
    return settings;
}

std::size_t number_of_loop(Machine const& machine, std::string const& name) {
    for (std::size_t i = 0; i < machine.loops.size(); ++i)
        if (machine.loop_name(i) == name)
            return i;
    throw std::logic_error("no loop " + name);
}

}  // namespace

TwinSettings twin_settings(AcceleratorConfig const& config, Machine const& machine, int width, int height) {
    TwinSettings settings;
    require_no_interlocks(machine);
    if (wants_lanes(config))
        settings.lanes = lane_settings(config, machine);
    else
        check_design(config, machine);
    settings.width = static_cast<std::uint16_t>(width);
    settings.height = static_cast<std::uint16_t>(height);
    settings.window = static_cast<std::uint16_t>(config.window);
    settings.fraction = config.fraction_bits;
    settings.sends_edges = config.rasterizer.edge_tokens == EdgeTokens::all;
    settings.is_inner_border = config.edge_map.algorithm == EdgeMapAlgorithm::inner_border;
    settings.flushes_last = config.edge_map.flush_last;
    settings.edge_map_clears_on_read_out = config.edge_map.clearing == MapClearing::on_read_out;
    settings.inlier_unit_clears_on_read_out = config.inlier_unit.clearing == MapClearing::on_read_out;
    settings.has_line_buffers = config.inlier_unit.neighbour_access == NeighbourAccess::window;
    settings.counts_hidden = counts_hidden(config.inlier_unit);
    settings.is_flattened = config.inlier_unit.fragment_loop == FragmentLoop::flattened;
    settings.reciprocals_squeeze = machine.fifos[machine.fifo("area_reciprocal")].when_full == WhenFull::squeeze;
    settings.area_reciprocal_interval =
        static_cast<std::uint8_t>(machine.processes[machine.process("area_reciprocal")].numbers.at("interval"));
    std::array<char const*, 3> const memories{"edge_map", "object_map", "depth_buffer"};
    for (std::size_t i = 0; i < memories.size(); ++i)
        settings.ports[i] = static_cast<std::uint8_t>(
            in_range(std::string("brams.") + memories[i] + ".ports", config.memory(memories[i]).ports, 1, most_cycles));
    settings.setup_cycles = static_cast<std::uint8_t>(
        in_range("loops.rasterizer.setup.depth", config.setup("rasterizer").value_or(default_setup_cycles),
                 settings.lanes ? least_lane_setup_cycles : 1, settings.lanes ? most_lane_setup_cycles : most_cycles));
    settings.fifo_rules = static_cast<std::uint8_t>(config.fifo_rules);
    for (std::size_t i = 0; i < twin_fifos.size(); ++i)
        settings.fifos[i] = fifo_settings(machine.fifos[machine.fifo(twin_fifos[i])], settings.lanes.has_value());
    for (std::size_t i = 0; i < twin_loops.size(); ++i)
        settings.loops[i] = loop_settings(machine.loops[number_of_loop(machine, twin_loops[i])], twin_loops[i],
                                          least_depth(twin_loops[i], config, machine));
    return settings;
}

}  // namespace faster::rtl
