#include <limits>
#include <string>

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

void add_fraction_keys(Keys& keys) {
    auto fractions =
        key_section(keys, "accelerator.fraction_bits", &FasterConfig::accelerator, &AcceleratorConfig::fraction_bits);
    auto const add = [&fractions](char const* name, std::string const& what, int max, int FractionBits::*bits) {
        fractions.integer(name, "bits", "Fractional bits of " + what + ".", "docs/function.md", {0, max}, bits);
    };
    add("vertex_xy", "vertex x and y [px], 16 bits signed", 15, &FractionBits::vertex_xy);
    add("vertex_z", "vertex z [m], 16 bits", 16, &FractionBits::vertex_z);
    add("area_reciprocal", "1 / area; with twice those of vertex_xy at most 62", 62, &FractionBits::area_reciprocal);
    add("fragment_depth", "the depth of one fragment [m]", 30, &FractionBits::fragment_depth);
    add("depth_buffer", "depth buffer and observed depth [m], 11 bits", 11, &FractionBits::depth_buffer);
}

Key threshold_key(std::size_t weight, std::string const& vertices) {
    auto const threshold = [weight](auto& config) -> auto& { return config.accelerator.edge_map.thresholds[weight]; };
    return Make::number_key(
        {"accelerator.edge_map.threshold_w" + std::to_string(weight), "px^2",
         "Algorithm threshold: how far from zero the edge value between vertices " + vertices + " may be at an edge.",
         "thesis 5.1; value: this project"},
        {0, std::numeric_limits<double>::infinity()}, threshold);
}

template <class Section, class Module>
void add_buffers_key(Section& module, std::string const& what, int Module::*buffers) {
    module.integer("buffers", "",
                   what +
                       " for samples in turn; with 2, a process of its own reads one out while the next sample's "
                       "tokens go into the other.",
                   "thesis A.2, A.3; 2: this project", {1, 2}, buffers);
}

template <class Section, class Module>
void add_clearing_key(Section& module, std::string const& what, MapClearing Module::*clearing) {
    module.choice("clearing", "",
                  "How " + what +
                      " become empty for the next sample: by a loop before it (wide: a word of every bank per "
                      "iteration), or by the loop that reads them out.",
                  "thesis A.2, A.3; others: this project", clearing);
}

void add_edge_map_keys(Keys& keys) {
    auto edge_map = key_section(keys, "accelerator.edge_map", &FasterConfig::accelerator, &AcceleratorConfig::edge_map);
    edge_map.choice("algorithm", "",
                    "How edge tokens become a contour; the thesis ends with dual_map, its Appendix A.2.",
                    "thesis 5, 4.1.2, 7.2", &EdgeMapConfig::algorithm);
    edge_map.boolean("flush_last", "",
                     "Whether the edge map builder finishes its last object token even after the end "
                     "token, which thesis A.2 does not.",
                     "docs/function.md", &EdgeMapConfig::flush_last);
    add_clearing_key(edge_map, "the maps", &EdgeMapConfig::clearing);
    add_buffers_key(edge_map, "Copies of the maps", &EdgeMapConfig::buffers);
    keys.push_back(threshold_key(0, "1 and 2"));
    keys.push_back(threshold_key(1, "2 and 0"));
    keys.push_back(threshold_key(2, "0 and 1"));
}

void add_rasterizer_keys(Keys& keys) {
    auto rasterizer =
        key_section(keys, "accelerator.rasterizer", &FasterConfig::accelerator, &AcceleratorConfig::rasterizer);
    rasterizer.choice(
        "scan", "",
        "Which pixels of a triangle's box the scan visits: all, those before its covered runs have ended, or only the "
        "runs.",
        "thesis A.1; early_exit, spans: this project", &RasterizerConfig::scan);
    rasterizer.integer(
        "setup_overlap", "triangles",
        "Triangles that are prepared while others are scanned, by one scan loop per sample; 0: each is prepared, then "
        "scanned by a loop of its own.",
        "thesis A.1; 1 or more: this project", {0, 1024}, &RasterizerConfig::setup_overlap);
    rasterizer.choice(
        "edge_tokens", "",
        "Whether the edge map builder gets tokens of the pixels beside a triangle too, or of covered pixels only; the "
        "latter will do for inner_border.",
        "thesis A.1; object: this project", &RasterizerConfig::edge_tokens);
    rasterizer.integer(
        "lanes", "px",
        "Adjacent pixels of a row that an iteration of the scan tests, and per token of fragments and edges; more "
        "than 1 needs inner_border with edge_tokens object, or flow fpga_grip.",
        "thesis A.1; more than 1: this project", {1, most_scan_lanes}, &RasterizerConfig::lanes);
}

void add_inlier_unit_keys(Keys& keys) {
    auto inlier_unit =
        key_section(keys, "accelerator.inlier_unit", &FasterConfig::accelerator, &AcceleratorConfig::inlier_unit);
    inlier_unit.choice(
        "neighbour_access", "",
        "How the sweep gets at a pixel's neighbours: five reads of the depth buffer, or one and two line buffers.",
        "thesis A.3; window: this project", &InlierUnitConfig::neighbour_access);
    add_clearing_key(inlier_unit, "the depth buffer's words", &InlierUnitConfig::clearing);
    add_buffers_key(inlier_unit, "Depth buffers", &InlierUnitConfig::buffers);
    inlier_unit.choice(
        "fragment_loop", "",
        "Whether each triangle's fragments are a loop that drains, or all commands of a sample are one loop.",
        "thesis A.3; flattened: this project", &InlierUnitConfig::fragment_loop);
    inlier_unit.integer(
        "sweep_lanes", "px",
        "Pixels of a row per iteration of the sweep, of the edge map's output and of the observation's read, and per "
        "token between them; at most the window.",
        "thesis A.3; more than 1: this project", {1, 4096}, &InlierUnitConfig::sweep_lanes);
    inlier_unit.choice(
        "sweep_region", "",
        "Which pixels the sweep, the edge map's output and the observation's read go over: the window, or the box "
        "that the sample's tokens touched.",
        "thesis A.2, A.3; touched: this project", &InlierUnitConfig::sweep_region);
    inlier_unit.choice(
        "hidden", "",
        "Whether the sweep counts drawn pixels in front of which something was measured, and has the box of the "
        "others.",
        "thesis A.3; counted: this project", &InlierUnitConfig::hidden);
}

void add_flow_key(Keys& keys) {
    keys.push_back(Make::choice_key(
        {"accelerator.flow", "",
         "How contours are found: while triangles are drawn (FASTER), or in the finished depth buffer (FPGA_GRIP).",
         "thesis 3.2, 6.2"},
        [](auto& config) -> auto& { return config.accelerator.flow; }));
}

void add_edge_extraction_keys(Keys& keys) {
    auto edge_extraction = key_section(keys, "accelerator.edge_extraction", &FasterConfig::accelerator,
                                       &AcceleratorConfig::edge_extraction);
    edge_extraction.integer("neighbourhood", "px", "Flow fpga_grip: side n of the n x n neighbourhood of eq. 2.2, odd.",
                            "thesis eq. 2.2; value: this project", {3, 15}, &EdgeExtractionConfig::neighbourhood);
    edge_extraction.number("threshold", "",
                           "Flow fpga_grip: a drawn pixel whose c(u, v) of eq. 2.2 is above this is an edge.",
                           "thesis eq. 2.2; value: this project", {0, 1000}, &EdgeExtractionConfig::threshold);
    edge_extraction.number(
        "focal_length_px", "px",
        "Flow fpga_grip: focal length that turns pixels of the window into points, a constant of the circuit.",
        "workload.camera.fx", {1, 1e6}, &EdgeExtractionConfig::focal_length_px);
    edge_extraction.choice(
        "neighbour_access", "",
        "Flow fpga_grip: how the neighbourhood is read: all of it from the depth buffer, or one word and line "
        "buffers.",
        "this project", &EdgeExtractionConfig::neighbour_access);
    // Both latencies add to the depth of inlier_unit.extract.
    Key& root = edge_extraction.integer("square_root_latency", "cycles",
                                        "Flow fpga_grip: stages of the square root unit, one per bit of its result.",
                                        "this project", cycles_range, &EdgeExtractionConfig::square_root_latency);
    root.is_step = root.decides_time = true;
    Key& divider = edge_extraction.integer(
        "divider_latency", "cycles", "Flow fpga_grip: stages of the divider, one per bit of its quotient and two.",
        "this project", cycles_range, &EdgeExtractionConfig::divider_latency);
    divider.is_step = divider.decides_time = true;
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
    append(keys, external_memory_keys());
    append(keys, memory_placement_keys());
    append(keys, machine_keys(core));
    append(keys, workload_keys());
    append(keys, estimator_keys());
    return keys;
}

}  // namespace faster
