#include <limits>

#include "dataflow/run/config/choice_names.hpp"
#include "dataflow/run/config/external_memory_keys.hpp"
#include "dataflow/run/config/machine_keys.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/config/faster_keys.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

using Make = KeyMaker<FasterConfig>;

constexpr IntegerRange cycles_range{1, 1'000'000};

template <class Field> Key fraction_key(std::string const& name, std::string const& what, int max, Field field) {
    return Make::integer_key(
        {"accelerator.fraction_bits." + name, "bits", "Fractional bits of " + what + ".", "docs/function.md"}, {0, max},
        field);
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
    return Make::number_key(
        {"accelerator.edge_map.threshold_" + weight, "px^2",
         "Algorithm threshold: how far from zero the edge value between vertices " + vertices + " may be at an edge.",
         "thesis 5.1; value: this project"},
        {0, std::numeric_limits<double>::infinity()}, field);
}

template <class Field> Key buffers_key(std::string const& module, std::string const& what, Field field) {
    return Make::integer_key({"accelerator." + module + ".buffers", "",
                              what + " for samples in turn; with 2, a process of its own reads one out while the next "
                                     "sample's tokens go into the other.",
                              "thesis A.2, A.3; 2: this project"},
                             {1, 2}, field);
}

template <class Field> Key clearing_key(std::string const& module, std::string const& what, Field field) {
    return Make::choice_key(
        {"accelerator." + module + ".clearing", "",
         "How " + what +
             " become empty for the next sample: by a loop before it (wide: a word of every bank per "
             "iteration), or by the loop that reads them out.",
         "thesis A.2, A.3; others: this project"},
        field);
}

void add_edge_map_keys(Keys& keys) {
    keys.push_back(Make::choice_key(
        {"accelerator.edge_map.algorithm", "",
         "How edge tokens become a contour; the thesis ends with dual_map, its Appendix A.2.", "thesis 5, 4.1.2, 7.2"},
        [](auto& config) -> auto& { return config.accelerator.edge_map.algorithm; }));
    keys.push_back(Make::boolean_key(
        {"accelerator.edge_map.flush_last", "",
         "Whether the edge map builder finishes its last object token even after the end "
         "token, which thesis A.2 does not.",
         "docs/function.md"},
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
    keys.push_back(Make::choice_key(
        {"accelerator.rasterizer.scan", "",
         "Which pixels of a triangle's box the scan visits: all, those before its covered runs have ended, or only the "
         "runs.",
         "thesis A.1; early_exit, spans: this project"},
        [](auto& config) -> auto& { return config.accelerator.rasterizer.scan; }));
    keys.push_back(Make::integer_key(
        {"accelerator.rasterizer.setup_overlap", "triangles",
         "Triangles that are prepared while others are scanned, by one scan loop per sample; 0: each is prepared, then "
         "scanned by a loop of its own.",
         "thesis A.1; 1 or more: this project"},
        {0, 1024}, [](auto& config) -> auto& { return config.accelerator.rasterizer.setup_overlap; }));
    keys.push_back(Make::choice_key(
        {"accelerator.rasterizer.edge_tokens", "",
         "Whether the edge map builder gets tokens of the pixels beside a triangle too, or of covered pixels only; the "
         "latter will do for inner_border.",
         "thesis A.1; object: this project"},
        [](auto& config) -> auto& { return config.accelerator.rasterizer.edge_tokens; }));
    keys.push_back(Make::integer_key(
        {"accelerator.rasterizer.lanes", "px",
         "Adjacent pixels of a row that an iteration of the scan tests, and per token of fragments and edges; more "
         "than 1 needs inner_border with edge_tokens object, or flow fpga_grip.",
         "thesis A.1; more than 1: this project"},
        {1, most_scan_lanes}, [](auto& config) -> auto& { return config.accelerator.rasterizer.lanes; }));
}

void add_inlier_unit_keys(Keys& keys) {
    keys.push_back(Make::choice_key(
        {"accelerator.inlier_unit.neighbour_access", "",
         "How the sweep gets at a pixel's neighbours: five reads of the depth buffer, or one and two line buffers.",
         "thesis A.3; window: this project"},
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.neighbour_access; }));
    keys.push_back(clearing_key(
        "inlier_unit", "the depth buffer's words",
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.clearing; }));
    keys.push_back(buffers_key(
        "inlier_unit", "Depth buffers", [](auto& config) -> auto& { return config.accelerator.inlier_unit.buffers; }));
    keys.push_back(Make::choice_key(
        {"accelerator.inlier_unit.fragment_loop", "",
         "Whether each triangle's fragments are a loop that drains, or all commands of a sample are one loop.",
         "thesis A.3; flattened: this project"},
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.fragment_loop; }));
    keys.push_back(Make::integer_key(
        {"accelerator.inlier_unit.sweep_lanes", "px",
         "Pixels of a row per iteration of the sweep, of the edge map's output and of the observation's read, and per "
         "token between them; at most the window.",
         "thesis A.3; more than 1: this project"},
        {1, 4096}, [](auto& config) -> auto& { return config.accelerator.inlier_unit.sweep_lanes; }));
    keys.push_back(Make::choice_key(
        {"accelerator.inlier_unit.sweep_region", "",
         "Which pixels the sweep, the edge map's output and the observation's read go over: the window, or the box "
         "that the sample's tokens touched.",
         "thesis A.2, A.3; touched: this project"},
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.sweep_region; }));
    keys.push_back(Make::choice_key(
        {"accelerator.inlier_unit.hidden", "",
         "Whether the sweep counts drawn pixels in front of which something was measured, and has the box of the "
         "others.",
         "thesis A.3; counted: this project"},
        [](auto& config) -> auto& { return config.accelerator.inlier_unit.hidden; }));
}

void add_flow_key(Keys& keys) {
    keys.push_back(Make::choice_key(
        {"accelerator.flow", "",
         "How contours are found: while triangles are drawn (FASTER), or in the finished depth buffer (FPGA_GRIP).",
         "thesis 3.2, 6.2"},
        [](auto& config) -> auto& { return config.accelerator.flow; }));
}

void add_edge_extraction_keys(Keys& keys) {
    keys.push_back(Make::integer_key(
        {"accelerator.edge_extraction.neighbourhood", "px",
         "Flow fpga_grip: side n of the n x n neighbourhood of eq. 2.2, odd.", "thesis eq. 2.2; value: this project"},
        {3, 15}, [](auto& config) -> auto& { return config.accelerator.edge_extraction.neighbourhood; }));
    keys.push_back(Make::number_key(
        {"accelerator.edge_extraction.threshold", "",
         "Flow fpga_grip: a drawn pixel whose c(u, v) of eq. 2.2 is above this is an edge.",
         "thesis eq. 2.2; value: this project"},
        {0, 1000}, [](auto& config) -> auto& { return config.accelerator.edge_extraction.threshold; }));
    keys.push_back(Make::number_key(
        {"accelerator.edge_extraction.focal_length_px", "px",
         "Flow fpga_grip: focal length that turns pixels of the window into points, a constant of the circuit.",
         "workload.camera.fx"},
        {1, 1e6}, [](auto& config) -> auto& { return config.accelerator.edge_extraction.focal_length_px; }));
    keys.push_back(Make::choice_key(
        {"accelerator.edge_extraction.neighbour_access", "",
         "Flow fpga_grip: how the neighbourhood is read: all of it from the depth buffer, or one word and line "
         "buffers.",
         "this project"},
        [](auto& config) -> auto& { return config.accelerator.edge_extraction.neighbour_access; }));
}

/// They add to the depth of inlier_unit.extract.
void add_unit_latency_keys(Keys& keys) {
    keys.push_back(step_of_time(Make::integer_key(
        {"accelerator.edge_extraction.square_root_latency", "cycles",
         "Flow fpga_grip: stages of the square root unit, one per bit of its result.", "this project"},
        cycles_range, [](auto& config) -> auto& { return config.accelerator.edge_extraction.square_root_latency; })));
    keys.push_back(step_of_time(Make::integer_key(
        {"accelerator.edge_extraction.divider_latency", "cycles",
         "Flow fpga_grip: stages of the divider, one per bit of its quotient and two.", "this project"},
        cycles_range, [](auto& config) -> auto& { return config.accelerator.edge_extraction.divider_latency; })));
}

void add_machine_keys(Keys& keys) {
    keys.push_back(architecture_key<FasterConfig>(
        "thesis 5, 7.2; others: this project", [](auto& config) -> auto& { return config.accelerator.architecture; }));
    keys.push_back(cores_key("accelerator.raster_cores", "Raster cores that share the samples.", "thesis 4.2.1"));
    keys.push_back(Make::integer_key(
        {"accelerator.window", "px", "Side of the square window around a sample's centre, the thesis's bounding box.",
         "thesis 3.2"},
        {1, 4096}, [](auto& config) -> auto& { return config.accelerator.window; }));
    keys.push_back(clock_key("thesis 4.2.3"));
    keys.push_back(fifo_rules_key());
}

void append(Keys& keys, Keys const& more) { keys.insert(keys.end(), more.begin(), more.end()); }

}  // namespace

Keys faster_keys(CoreDescription const& core) {
    Keys keys;
    add_machine_keys(keys);
    add_flow_key(keys);
    add_fraction_keys(keys);
    add_edge_map_keys(keys);
    add_rasterizer_keys(keys);
    add_inlier_unit_keys(keys);
    add_edge_extraction_keys(keys);
    add_unit_latency_keys(keys);
    append(keys, external_memory_keys());
    append(keys, memory_placement_keys());
    append(keys, machine_keys(core));
    append(keys, workload_keys());
    append(keys, estimator_keys());
    return keys;
}

}  // namespace faster
