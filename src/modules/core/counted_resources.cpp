#include "modules/core/counted_resources.hpp"

#include <algorithm>
#include <cmath>

#include "dataflow/base/integer_bits.hpp"
#include "faster/config/sweep_design.hpp"
#include "faster/config/synthesized_units.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

namespace {

constexpr Resources nothing{};

double count(int number) { return static_cast<double>(number); }

ResourcePart counted(std::string name, Resources const& amount) {
    return {std::move(name), amount, ResourceBasis::counted};
}

ResourcePart with_lanes(char const* unit, int lanes) {
    return synthesized_units().unit(unit, {{"lanes", std::to_string(lanes), "1"}});
}
Resources synthesized(char const* unit) { return synthesized_units().unit(unit, {}).amount; }

/// What a unit takes more with so many lanes than with one.
ResourcePart more_lanes(std::string name, char const* unit, int lanes) {
    ResourcePart const part = with_lanes(unit, lanes);
    return {std::move(name), part.amount - synthesized(unit), part.basis};
}

/// Where edges cross rows, and how far from row to row: a triangle every third cycle where they are set up ahead.
ResourcePart span_dividers(RasterizerConfig const& rasterizer) {
    ResourcePart const of_edge =
        synthesized_units().unit("span_division", {{"interval", rasterizer.setup_overlap > 0 ? "3" : "18", "3"}});
    return {"dividers of spans", 3.0 * of_edge.amount, of_edge.basis};
}

/// Rows of spans, ahead of the scan, in place of the zigzag.
ResourcePart span_scan(int lanes) {
    ResourcePart const rows = with_lanes("span_rows", lanes), scan = with_lanes("span_scan", lanes);
    return {"scan of spans, without the zigzag scan", rows.amount + scan.amount - synthesized("zigzag_scan"),
            std::max(rows.basis, scan.basis)};
}

/// Of a memory in banks or buffers: an address bit of each bank is one of two, as are two bits of its word.
Resources bank_multiplexers(MachineMemory const& memory) {
    MemoryShape const& shape = memory.shape;
    auto const banks = static_cast<double>(shape.partition * shape.buffers);
    if (banks < 2 || shape.words == 0)
        return nothing;
    double const address_bits =
        std::ceil(std::log2(static_cast<double>(shape.words) / static_cast<double>(shape.partition)));
    return {banks * (address_bits + static_cast<double>(shape.bits) / 2), 0, 0, 0};
}

/// Corners of the region, and their tokens' number: with lanes, two divisions.
ResourcePart corners(AcceleratorConfig const& config) {
    double const divisions = is_power_of_two(static_cast<std::uint64_t>(config.inlier_unit.sweep_lanes)) ? 0 : 2;
    return counted("corners of the touched region", {20 + divisions / 3 * 30, 36, 0, 0});
}

/// Roots of two lengths and their quotient, a stage per bit; points and squares. docs/modules/edge_extractor.md.
ResourcePart edge_extractor(EdgeExtractionConfig const& extraction) {
    double const roots = 2 * count(static_cast<int>(extraction.square_root_latency));
    double const quotient = count(static_cast<int>(extraction.divider_latency));
    double const side = extraction.neighbourhood;
    return counted("edge extractor", {roots * 17 + quotient * 30 + 12 * side * 15,
                                      roots * 44 + quotient * 75 + side * side * 11, 10 + side, 0});
}

void add(ResourceParts& parts, ResourceParts const& more) { parts.insert(parts.end(), more.begin(), more.end()); }

}  // namespace

ResourceParts choice_of_banks(Machine const& machine, std::vector<std::string> const& memories) {
    Resources sum;
    for (std::string const& memory : memories)
        sum += bank_multiplexers(machine.memories[machine.memory(memory)]);
    return sum.lut > 0 ? ResourceParts{counted("choice of banks and buffers", sum)} : ResourceParts{};
}

ResourcePart table_of_valid_depths() { return counted("four words of the table of valid depths", {80, 50, 1, 0}); }

ResourceParts counted_in_vertex_transform(AcceleratorConfig const& config) {
    if (config.memory_placement.mesh == Placement::external)
        return {};
    return {counted("mesh on the chip: its counter and its loading", {60, 80, 0, 0})};
}

ResourceParts counted_in_rasterizer(AcceleratorConfig const& config) {
    RasterizerConfig const& rasterizer = config.rasterizer;
    ResourceParts parts;
    if (rasterizer.setup_overlap > 0)  // 470 bits each, as shift registers
        parts.push_back(counted("triangles set up ahead",
                                {470 * std::ceil(static_cast<double>(rasterizer.setup_overlap) / 16), 500, 0, 0}));
    if (rasterizer.scan == ScanPolicy::early_exit)
        parts.push_back(counted("edge values of the row below", {90, 87, 0, 0}));
    if (rasterizer.scan == ScanPolicy::spans) {
        parts.push_back(span_dividers(rasterizer));
        parts.push_back(span_scan(rasterizer.lanes));
    } else if (rasterizer.lanes > 1) {
        parts.push_back(counted("z sums and masks of lanes", count(rasterizer.lanes - 1) * Resources{163, 210, 0, 0}));
    }
    if (config.inlier_unit.sweep_region == SweepRegion::touched)
        parts.push_back(counted("least and greatest pixel touched", {60, 36, 0, 0}));
    return parts;
}

ResourceParts counted_in_edge_map_builder(AcceleratorConfig const& config, Machine const& machine) {
    ResourceParts parts;
    EdgeMapAlgorithm const algorithm = config.edge_map.algorithm;
    if (algorithm != EdgeMapAlgorithm::dual_map && algorithm != EdgeMapAlgorithm::inner_border)
        parts.push_back(counted("this algorithm, as much as dual_map", nothing));
    add(parts, choice_of_banks(machine, {"edge_map", "object_map"}));
    if (config.inlier_unit.sweep_lanes > 1)
        parts.push_back(more_lanes("lanes of the map's output", "lane_map_output", config.inlier_unit.sweep_lanes));
    if (config.rasterizer.lanes > 1)
        parts.push_back(more_lanes("lanes of the map's tokens", "lane_map_builder", config.rasterizer.lanes));
    if (config.inlier_unit.sweep_region == SweepRegion::touched)
        parts.push_back(corners(config));
    return parts;
}

ResourceParts counted_in_observation_reader(AcceleratorConfig const& config) {
    ResourceParts parts;
    if (config.inlier_unit.sweep_lanes > 1)
        parts.push_back(
            more_lanes("lanes of the observation", "lane_observation_reader", config.inlier_unit.sweep_lanes));
    if (config.inlier_unit.sweep_region == SweepRegion::touched) {
        parts.push_back(corners(config));
        parts.push_back(table_of_valid_depths());
    }
    return parts;
}

ResourceParts counted_in_inlier_unit(AcceleratorConfig const& config, Machine const& machine) {
    ResourceParts parts;
    if (config.rasterizer.lanes > 1)
        parts.push_back({"depths, depth tests and forwarding of lanes",
                         count(config.rasterizer.lanes - 1) * synthesized("lane_depth_unit"),
                         ResourceBasis::synthesized});
    if (config.inlier_unit.sweep_lanes > 1)
        parts.push_back(more_lanes("lanes of the sweep", "lane_sweep", config.inlier_unit.sweep_lanes));
    add(parts, choice_of_banks(machine, {"depth_buffer"}));
    if (config.inlier_unit.sweep_region == SweepRegion::touched)
        parts.push_back(corners(config));
    if (config.flow == Flow::fpga_grip)
        parts.push_back(edge_extractor(config.edge_extraction));
    return parts;
}

ResourceParts counted_in_read_out() { return {counted("control of a second buffer", {40, 130, 0, 0})}; }

}  // namespace faster
