#include <algorithm>
#include <fmt/format.h>

#include "faster/parts.hpp"
#include "faster/presets.hpp"
#include "kernel/config/key_builders.hpp"
#include "kernel/config/key_names.hpp"
#include "kernel/config/keys.hpp"

namespace faster {
namespace {

constexpr IntegerRange cycles_range{1, 1'000'000};

constexpr std::array<char const*, fifo_count> fifo_tokens{
    "sample headers from the dispatcher to the vertex transform",
    "sample headers from the dispatcher to the rasterizer",
    "sample headers from the dispatcher to the observation reader",
    "vertices from the vertex transform to the rasterizer",
    "triangle areas from the rasterizer to the reciprocal unit",
    "1 / area from the reciprocal unit to the inlier unit",
    "commands from the rasterizer to the inlier unit",
    "z sums of fragments from the rasterizer to the inlier unit",
    "pixels of fragments from the rasterizer to the inlier unit",
    "object and edge pixels from the rasterizer to the edge map builder",
    "edge bits from the edge map builder to the inlier unit",
    "observed depths from the observation reader to the inlier unit",
    "observed edge bits from the observation reader to the inlier unit",
    "counters of a sample from the inlier unit to the result collector",
    "two corners of the touched region from the rasterizer to the observation reader (sweep_region: touched)",
    "observed pixels of valid depth from the observation reader to the result collector (sweep_region: touched)",
    "finished maps from the edge map builder to the edge map output (edge_map.buffers 2)",
    "maps read out, from the edge map output to the edge map builder (edge_map.buffers 2)",
    "drawn depth buffers from the inlier unit to the inlier sweep (inlier_unit.buffers 2)",
    "swept depth buffers from the inlier sweep to the inlier unit (inlier_unit.buffers 2)"};

constexpr std::array<char const*, keyed_loop_count> loop_tasks{
    "transforms one vertex per iteration",
    "visits one pixel or group per iteration, or sends a pending edge token",
    "clears one pixel of both maps, or one of every bank, per iteration",
    "takes one edge token per iteration, or finishes the object token before it",
    "sends one token of edge bits per iteration",
    "reads one token of observed pixels per iteration",
    "fills one word of the depth buffer, or one of every bank, per iteration",
    "takes one fragment or group per iteration",
    "judges one token of pixels per iteration",
    "looks for an edge at one pixel of the window per iteration (flow fpga_grip)"};

constexpr std::array<char const*, bram_count> bram_contents{"edge bits of the window", "object bits of the window",
                                                            "depth buffer of the window"};

template <class Field> Key fraction_key(std::string const& name, std::string const& what, int max, Field field) {
    return integer_key({"accelerator.fraction_bits." + name, "bits", "Fractional bits of " + what + ".", "SPEC 2"},
                       {0, max}, field);
}

void add_fraction_keys(Keys& keys) {
    keys.push_back(fraction_key(
        "vertex_xy", "vertex x and y [px], 16 bits signed", 15,
        [](auto& config) -> auto& { return config.accelerator.fraction_bits.vertex_xy; }));
    keys.push_back(fraction_key(
        "vertex_z", "vertex z [m], 16 bits", 16,
        [](auto& config) -> auto& { return config.accelerator.fraction_bits.vertex_z; }));
    keys.push_back(fraction_key(
        "area_reciprocal", "1 / area; with twice those of vertex_xy at most 62", 62,
        [](auto& config) -> auto& { return config.accelerator.fraction_bits.area_reciprocal; }));
    keys.push_back(fraction_key(
        "fragment_depth", "the depth of one fragment [m]", 30,
        [](auto& config) -> auto& { return config.accelerator.fraction_bits.fragment_depth; }));
    keys.push_back(fraction_key(
        "depth_buffer", "depth buffer and observed depth [m], 11 bits", 11,
        [](auto& config) -> auto& { return config.accelerator.fraction_bits.depth_buffer; }));
}

template <class Field> Key threshold_key(std::string const& weight, std::string const& vertices, Field field) {
    return number_key(
        {"accelerator.edge_map.threshold_" + weight, "px^2",
         "Algorithm threshold: how far from zero the edge value between vertices " + vertices + " may be at an edge.",
         "thesis 5.1; value: this project"},
        {0, std::numeric_limits<double>::infinity()}, field);
}

template <class Field> Key buffers_key(std::string const& module, std::string const& what, Field field) {
    return integer_key({"accelerator." + module + ".buffers", "",
                        what + " for samples in turn; with 2, a process of its own reads one out while the next "
                               "sample's tokens go into the other.",
                        "thesis A.2, A.3; 2: this project"},
                       {1, 2}, field);
}

template <class Field> Key clearing_key(std::string const& module, std::string const& what, Field field) {
    return choice_key({"accelerator." + module + ".clearing", "",
                       "How " + what +
                           " become empty for the next sample: by a loop before it (wide: a word of every bank per "
                           "iteration), or by the loop that reads them out.",
                       "thesis A.2, A.3; others: this project"},
                      field);
}

void add_edge_map_keys(Keys& keys) {
    keys.push_back(choice_key(
        {"accelerator.edge_map.algorithm", "",
         "How edge tokens become a contour; the thesis ends with dual_map, its Appendix A.2.", "thesis 5, 4.1.2, 7.2"},
        [](auto& config) -> auto& { return config.accelerator.edge_map.algorithm; }));
    keys.push_back(boolean_key(
        {"accelerator.edge_map.flush_last", "",
         "Whether the edge map builder finishes its last object token even after the end "
         "token, which thesis A.2 does not.",
         "SPEC 2"},
        [](auto& config) -> auto& { return config.accelerator.edge_map.flush_last; }));
    keys.push_back(clearing_key(
        "edge_map", "the maps", [](auto& config) -> auto& { return config.accelerator.edge_map.clearing; }));
    keys.push_back(buffers_key(
        "edge_map", "Copies of the maps", [](auto& config) -> auto& { return config.accelerator.edge_map.buffers; }));
    keys.push_back(threshold_key(
        "w0", "1 and 2", [](auto& config) -> auto& { return config.accelerator.edge_map.thresholds[0]; }));
    keys.push_back(threshold_key(
        "w1", "2 and 0", [](auto& config) -> auto& { return config.accelerator.edge_map.thresholds[1]; }));
    keys.push_back(threshold_key(
        "w2", "0 and 1", [](auto& config) -> auto& { return config.accelerator.edge_map.thresholds[2]; }));
}

void add_rasterizer_keys(Keys& keys) {
    keys.push_back(choice_key(
        {"accelerator.rasterizer.scan", "",
         "Which pixels of a triangle's box the scan visits: all, those before its covered runs have ended, or only the "
         "runs.",
         "thesis A.1; early_exit, spans: this project"},
        [](auto& config) -> auto& { return config.accelerator.rasterizer.scan; }));
    keys.push_back(integer_key(
        {"accelerator.rasterizer.setup_overlap", "triangles",
         "Triangles that are prepared while others are scanned, by one scan loop per sample; 0: each is prepared, then "
         "scanned by a loop of its own.",
         "thesis A.1; 1 or more: this project"},
        {0, 1024}, [](auto& config) -> auto& { return config.accelerator.rasterizer.setup_overlap; }));
    keys.push_back(choice_key(
        {"accelerator.rasterizer.edge_tokens", "",
         "Whether the edge map builder gets tokens of the pixels beside a triangle too, or of covered pixels only; the "
         "latter will do for inner_border.",
         "thesis A.1; object: this project"},
        [](auto& config) -> auto& { return config.accelerator.rasterizer.edge_tokens; }));
    keys.push_back(integer_key(
        {"accelerator.rasterizer.lanes", "px",
         "Adjacent pixels of a row that an iteration of the scan tests, and per token of fragments and edges; more "
         "than 1 needs inner_border with edge_tokens object, or flow fpga_grip.",
         "thesis A.1; more than 1: this project"},
        {1, most_scan_lanes}, [](auto& config) -> auto& { return config.accelerator.rasterizer.lanes; }));
}

void add_inlier_unit_keys(Keys& keys) {
    keys.push_back(choice_key(
        {"accelerator.inlier_unit.neighbour_access", "",
         "How the sweep gets at a pixel's neighbours: five reads of the depth buffer, or one and two line buffers.",
         "thesis A.3; window: this project"},
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.neighbour_access; }));
    keys.push_back(clearing_key(
        "inlier_unit", "the depth buffer's words",
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.clearing; }));
    keys.push_back(buffers_key(
        "inlier_unit", "Depth buffers", [](auto& config) -> auto& { return config.accelerator.inlier_unit.buffers; }));
    keys.push_back(choice_key(
        {"accelerator.inlier_unit.fragment_loop", "",
         "Whether each triangle's fragments are a loop that drains, or all commands of a sample are one loop.",
         "thesis A.3; flattened: this project"},
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.fragment_loop; }));
    keys.push_back(integer_key(
        {"accelerator.inlier_unit.sweep_lanes", "px",
         "Pixels of a row per iteration of the sweep, of the edge map's output and of the observation's read, and per "
         "token between them; at most the window.",
         "thesis A.3; more than 1: this project"},
        {1, 4096}, [](auto& config) -> auto& { return config.accelerator.inlier_unit.sweep_lanes; }));
    keys.push_back(choice_key(
        {"accelerator.inlier_unit.sweep_region", "",
         "Which pixels the sweep, the edge map's output and the observation's read go over: the window, or the box "
         "that the sample's tokens touched.",
         "thesis A.2, A.3; touched: this project"},
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.sweep_region; }));
}

void add_flow_key(Keys& keys) {
    keys.push_back(choice_key(
        {"accelerator.flow", "",
         "How contours are found: while triangles are drawn (FASTER), or in the finished depth buffer (FPGA_GRIP).",
         "thesis 3.2, 6.2"},
        [](auto& config) -> auto& { return config.accelerator.flow; }));
}

void add_edge_extraction_keys(Keys& keys) {
    keys.push_back(integer_key(
        {"accelerator.edge_extraction.neighbourhood", "px",
         "Flow fpga_grip: side n of the n x n neighbourhood of eq. 2.2, odd.", "thesis eq. 2.2; value: this project"},
        {3, 15}, [](auto& config) -> auto& { return config.accelerator.edge_extraction.neighbourhood; }));
    keys.push_back(number_key(
        {"accelerator.edge_extraction.threshold", "",
         "Flow fpga_grip: a drawn pixel whose c(u, v) of eq. 2.2 is above this is an edge.",
         "thesis eq. 2.2; value: this project"},
        {0, 1000}, [](auto& config) -> auto& { return config.accelerator.edge_extraction.threshold; }));
    keys.push_back(number_key(
        {"accelerator.edge_extraction.focal_length_px", "px",
         "Flow fpga_grip: focal length that turns pixels of the window into points, a constant of the circuit.",
         "workload.camera.fx"},
        {1, 1e6}, [](auto& config) -> auto& { return config.accelerator.edge_extraction.focal_length_px; }));
    keys.push_back(choice_key(
        {"accelerator.edge_extraction.neighbour_access", "",
         "Flow fpga_grip: how the neighbourhood is read: all of it from the depth buffer, or one word and line "
         "buffers.",
         "this project"},
        [](auto& config) -> auto& { return config.accelerator.edge_extraction.neighbour_access; }));
}

/// They add to the depth of inlier_unit.extract.
void add_unit_latency_keys(Keys& keys) {
    keys.push_back(integer_key(
        {"accelerator.edge_extraction.square_root_latency", "cycles",
         "Flow fpga_grip: stages of the square root unit, one per bit of its result.", "this project"},
        cycles_range, [](auto& config) -> auto& { return config.accelerator.edge_extraction.square_root_latency; }));
    keys.push_back(integer_key(
        {"accelerator.edge_extraction.divider_latency", "cycles",
         "Flow fpga_grip: stages of the divider, one per bit of its quotient and two.", "this project"},
        cycles_range, [](auto& config) -> auto& { return config.accelerator.edge_extraction.divider_latency; }));
}

std::string write_latency_meaning(FifoId id) {
    std::optional<LoopId> const loop = loop_that_writes(id);
    if (!loop) {
        return "Pipeline stages from the read of an area to the write of its reciprocal.";
    }
    return fmt::format("Stage of the writing loop in which the token leaves, below {}.", loop_key_name(*loop, "depth"));
}

void add_fifo_keys(Keys& keys, FifoId id) {
    keys.push_back(integer_key(
        {fifo_key_name(id, "depth"), "tokens", fmt::format("Depth of the FIFO: {}.", fifo_tokens[index_of(id)]),
         "HLS default"},
        {1, 1'048'576}, [id](auto& config) -> auto& { return config.accelerator.fifo(id).depth; }));
    keys.push_back(choice_key(
        {fifo_key_name(id, "kind"), "", "How the FIFO is built; auto is a shift register up to depth 2, else a memory.",
         "SPEC 3"},
        [id](auto& config) -> auto& { return config.accelerator.fifo(id).kind; }));
    if (has_write_latency(id)) {
        keys.push_back(integer_key(
            {fifo_key_name(id, "write_latency"), "cycles", write_latency_meaning(id), "SPEC 3"},
            {0, 1'000'000}, [id](auto& config) -> auto& { return config.accelerator.fifo(id).write_latency; }));
    }
}

/// Not a loop, but it stands among them in the rasterizer's section.
void add_setup_key(Keys& keys) {
    keys.push_back(integer_key(
        {"accelerator.loops.rasterizer.setup.depth", "cycles",
         "Cycles of the triangle setup, from the third vertex to the area.", "SPEC 3"},
        cycles_range, [](auto& config) -> auto& { return config.accelerator.setup_depth; }));
}

void add_loop_keys(Keys& keys, LoopId id) {
    keys.push_back(integer_key(
        {loop_key_name(id, "ii"), "cycles",
         fmt::format("Initiation interval the pragma asks for; the loop {}.", loop_tasks[index_of(id)]), "thesis 5.4"},
        cycles_range, [id](auto& config) -> auto& { return config.accelerator.loop(id).ii; }));
    keys.push_back(integer_key(
        {loop_key_name(id, "recurrence_ii"), "cycles",
         "Initiation interval that a dependence between iterations demands.", "thesis 5.4"},
        cycles_range, [id](auto& config) -> auto& { return config.accelerator.loop(id).recurrence_ii; }));
    keys.push_back(integer_key(
        {loop_key_name(id, "depth"), "cycles", "Pipeline stages of one iteration.", "SPEC 3"},
        cycles_range, [id](auto& config) -> auto& { return config.accelerator.loop(id).depth; }));
}

void add_bram_keys(Keys& keys, BramId id) {
    keys.push_back(integer_key(
        {bram_key_name(id, "ports"), "accesses per cycle",
         fmt::format("Ports of the block RAM, of each bank if it is split: {}.", bram_contents[index_of(id)]),
         "thesis 5.4"},
        {1, 1024}, [id](auto& config) -> auto& { return config.accelerator.bram(id).ports; }));
}

/// Timing keys, but no steps of one quantity: a factor means nothing without a type.
void add_partition_keys(Keys& keys, BramId id) {
    std::string const memory = name_of(id);
    keys.push_back(choice_key(
        {bram_key_name(id, "partition.type"), "",
         "How " + memory + " is split into banks, each with its own ports: cyclic parts neighbours, block does not.",
         "HLS array_partition; default: thesis A.2, A.3"},
        [id](auto& config) -> auto& { return config.accelerator.bram(id).partition.type; }));
    keys.push_back(integer_key(
        {bram_key_name(id, "partition.factor"), "banks",
         "Banks along each dimension that is split; 1024 in all at most.", "HLS array_partition"},
        {1, 1024}, [id](auto& config) -> auto& { return config.accelerator.bram(id).partition.factor; }));
    keys.push_back(integer_key(
        {bram_key_name(id, "partition.dimension"), "", "What is split: 1 the rows, 2 the columns, 0 both.",
         "HLS array_partition"},
        {0, 2}, [id](auto& config) -> auto& { return config.accelerator.bram(id).partition.dimension; }));
}

void add_loops_keys(Keys& keys) {
    for (std::size_t index = 0; index < keyed_loop_count; ++index) {
        if (LoopId{index} == LoopId::scan) {
            add_setup_key(keys);
        }
        add_loop_keys(keys, LoopId{index});
    }
}

void add_timing_keys(Keys& keys) {
    add_unit_latency_keys(keys);
    for (std::size_t index = 0; index < fifo_count; ++index) {
        add_fifo_keys(keys, FifoId{index});
    }
    add_loops_keys(keys);
    for (std::size_t index = 0; index < bram_count; ++index) {
        add_bram_keys(keys, BramId{index});
        add_partition_keys(keys, BramId{index});
    }
}

bool is_step_by_step(Key const& key) {
    return key.kind == KeyKind::integer && key.name().find(".partition.") == std::string::npos;
}

void add_cores_key(Keys& keys) {
    keys.push_back(integer_key(
        {"accelerator.raster_cores", "cores", "Raster cores that share the samples.", "thesis 4.2.1"}, {1, 1024},
        [](auto& config) -> auto& { return config.accelerator.raster_cores; }));
}

void add_clock_key(Keys& keys) {
    keys.push_back(number_key(
        {"accelerator.clock_mhz", "MHz", "Clock that turns cycles into milliseconds.", "thesis 4.2.3"},
        {0, std::numeric_limits<double>::infinity(), true},
        [](auto& config) -> auto& { return config.accelerator.clock_mhz; }));
}

void add_architecture_key(Keys& keys) {
    Key key = make_key(
        {"accelerator.architecture", "",
         "A design to start from: a file of configs/architectures, whose values the other keys here change.",
         "thesis 5, 7.2; others: this project"},
        KeyKind::choice, [](auto& config) -> auto& { return config.accelerator.architecture; });
    key.choices = preset_names();
    keys.push_back(std::move(key));
}

void add_machine_keys(Keys& keys) {
    add_architecture_key(keys);
    add_cores_key(keys);
    keys.push_back(integer_key(
        {"accelerator.window", "px", "Side of the square window around a sample's centre, the thesis's bounding box.",
         "thesis 3.2"},
        {1, 4096}, [](auto& config) -> auto& { return config.accelerator.window; }));
    add_clock_key(keys);
}

}  // namespace

Keys retiming_keys() {
    Keys keys;
    add_cores_key(keys);
    add_clock_key(keys);
    add_timing_keys(keys);
    return keys;
}

Keys timing_keys(Parts const& parts) {
    Keys keys;
    add_timing_keys(keys);
    auto const is_left_out = [&parts](Key const& key) {
        return !is_step_by_step(key) || !applies_to(parts, key.name());
    };
    keys.erase(std::remove_if(keys.begin(), keys.end(), is_left_out), keys.end());
    return keys;
}

Keys accelerator_keys() {
    Keys keys;
    add_machine_keys(keys);
    add_flow_key(keys);
    add_fraction_keys(keys);
    add_edge_map_keys(keys);
    add_rasterizer_keys(keys);
    add_inlier_unit_keys(keys);
    add_edge_extraction_keys(keys);
    add_timing_keys(keys);
    return keys;
}

}  // namespace faster
