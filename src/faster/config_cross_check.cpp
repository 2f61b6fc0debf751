#include <fmt/format.h>

#include "faster/parts.hpp"
#include "kernel/config/config_sources.hpp"
#include "kernel/config/key_names.hpp"
#include "kernel/config/keys.hpp"

namespace faster {
namespace {

constexpr char const* area_reciprocal_key = "accelerator.fraction_bits.area_reciprocal";
constexpr char const* vertex_xy_key = "accelerator.fraction_bits.vertex_xy";
constexpr int most_reciprocal_bits = 62;  ///< 2^(area_reciprocal + 2 * vertex_xy) and what it divides fit 63 bits

/// The token leaves before the pipeline ends. If only the loop's depth was set, that is what the message blames.
void check_write_latency(LoadedConfig const& loaded, FifoId fifo, std::vector<std::string>& complaints) {
    auto const loop = loop_that_writes(fifo);
    if (!loop) {
        return;
    }
    Cycles const latency = loaded.config.accelerator.fifo(fifo).write_latency;
    Cycles const depth = loaded.config.accelerator.loop(*loop).depth;
    if (latency < depth) {
        return;
    }
    std::string const latency_key = fifo_key_name(fifo, "write_latency");
    std::string const depth_key = loop_key_name(*loop, "depth");
    if (loaded.origins.is_explicit(latency_key)) {
        complaints.push_back(
            complaint(loaded, latency_key,
                      fmt::format("at most {}, one less than {}", depth - 1, with_value(loaded, depth_key))));
    } else {
        complaints.push_back(complaint(loaded, depth_key,
                                       fmt::format("at least {} because of {}: set that too, to at most {}",
                                                   latency + 1, with_value(loaded, latency_key), depth - 1)));
    }
}

void check_fraction_bits(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    FractionBits const& bits = loaded.config.accelerator.fraction_bits;
    if (bits.area_reciprocal + 2 * bits.vertex_xy <= most_reciprocal_bits) {
        return;
    }
    if (loaded.origins.is_explicit(area_reciprocal_key)) {
        complaints.push_back(
            complaint(loaded, area_reciprocal_key,
                      fmt::format("at most {}, which is {} minus twice {}", most_reciprocal_bits - 2 * bits.vertex_xy,
                                  most_reciprocal_bits, with_value(loaded, vertex_xy_key))));
    } else {
        complaints.push_back(complaint(
            loaded, vertex_xy_key,
            fmt::format("at most {}, which is half of {} minus {}", (most_reciprocal_bits - bits.area_reciprocal) / 2,
                        most_reciprocal_bits, with_value(loaded, area_reciprocal_key))));
    }
}

/// Its edge tokens lie around the triangle, where only the zigzag looks.
void check_scan(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    constexpr char const* scan_key = "accelerator.rasterizer.scan";
    constexpr char const* algorithm_key = "accelerator.edge_map.algorithm";
    AcceleratorConfig const& accelerator = loaded.config.accelerator;
    if (accelerator.edge_map.algorithm != EdgeMapAlgorithm::threshold ||
        accelerator.rasterizer.scan == ScanPolicy::zigzag) {
        return;
    }
    complaints.push_back(complaint(loaded, scan_key,
                                   fmt::format("zigzag because of {}, whose edge tokens lie outside the triangles too",
                                               with_value(loaded, algorithm_key))));
}

/// All other algorithms build their contours of the pixels beside the triangles.
void check_edge_tokens(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    AcceleratorConfig const& accelerator = loaded.config.accelerator;
    if (accelerator.rasterizer.edge_tokens == EdgeTokens::all || accelerator.flow != Flow::faster ||
        accelerator.edge_map.algorithm == EdgeMapAlgorithm::inner_border)
        return;
    complaints.push_back(
        complaint(loaded, "accelerator.rasterizer.edge_tokens",
                  fmt::format("all because of {}", with_value(loaded, "accelerator.edge_map.algorithm"))));
}

void check_lanes(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    AcceleratorConfig const& config = loaded.config.accelerator;
    if (config.inlier_unit.sweep_lanes > config.window) {
        complaints.push_back(complaint(loaded, "accelerator.inlier_unit.sweep_lanes",
                                       fmt::format("at most {}", with_value(loaded, "accelerator.window"))));
    }
}

/// Tokens of several pixels say which are covered, and nothing of those beside a triangle.
void check_scan_lanes(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    constexpr char const* lanes_key = "accelerator.rasterizer.lanes";
    AcceleratorConfig const& config = loaded.config.accelerator;
    bool const needs_covered_only = config.flow == Flow::faster && config.rasterizer.lanes > 1;
    if (needs_covered_only && (config.edge_map.algorithm != EdgeMapAlgorithm::inner_border ||
                               config.rasterizer.edge_tokens != EdgeTokens::object)) {
        complaints.push_back(complaint(loaded, lanes_key,
                                       fmt::format("1, or {} to be inner_border and {} to be object",
                                                   with_value(loaded, "accelerator.edge_map.algorithm"),
                                                   with_value(loaded, "accelerator.rasterizer.edge_tokens"))));
    } else if (config.rasterizer.lanes > config.window) {
        complaints.push_back(
            complaint(loaded, lanes_key, fmt::format("at most {}", with_value(loaded, "accelerator.window"))));
    }
}

/// Where nothing is drawn the depth buffer says "far", which has to lie beyond the 2 m up to which the sweep compares.
void check_sweep_region(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    constexpr int most_bits = 9;  // 2 m is code 1024 then, far is 2047
    AcceleratorConfig const& config = loaded.config.accelerator;
    if (config.inlier_unit.sweep_region == SweepRegion::touched && config.fraction_bits.depth_buffer > most_bits) {
        complaints.push_back(
            complaint(loaded, "accelerator.inlier_unit.sweep_region",
                      fmt::format("window because of {}, with which pixels that nothing touched are nearer than 2 m",
                                  with_value(loaded, "accelerator.fraction_bits.depth_buffer"))));
    }
}

void check_neighbourhood(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    if (loaded.config.workload.observed_edges.neighbourhood % 2 == 0) {
        complaints.push_back(complaint(loaded, "workload.observed_edges.neighbourhood", "an odd number"));
    }
}

void check_edge_extraction(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    if (loaded.config.accelerator.edge_extraction.neighbourhood % 2 == 0) {
        complaints.push_back(complaint(loaded, "accelerator.edge_extraction.neighbourhood", "an odd number"));
    }
}

/// A key of a part that is not there would change nothing. Its default is no complaint: a resolved configuration says
/// all.
void check_parts(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    Parts const parts(loaded.config.accelerator);
    RunConfig const defaults;
    for (Key const& key : all_keys()) {
        bool const is_asked_for = loaded.origins.is_explicit(key.name()) &&
                                  json_text(key.read(loaded.config)) != json_text(key.read(defaults));
        if (is_asked_for && !applies_to(parts, key.name())) {
            complaints.push_back(complaint(loaded, key.name(),
                                           fmt::format("a key of the parts that {} has",
                                                       with_value(loaded, key_that_decides(parts, key.name())))));
        }
    }
}

}  // namespace

std::string with_value(LoadedConfig const& loaded, std::string const& key) {
    return fmt::format("{} = {}{}", key, json_text(find_key(key)->read(loaded.config)),
                       loaded.origins.is_explicit(key) ? "" : " (default)");
}

std::string complaint(LoadedConfig const& loaded, std::string const& key, std::string const& expected) {
    KeyOrigin const origin = loaded.origins.of(key);
    if (origin.source == KeySource::command_line) {
        return origin.place + ": expected " + expected;  // key and value stand in the place
    }
    std::string const value = with_value(loaded, key) + ", expected " + expected;
    return origin.place.empty() ? value : origin.place + ": " + value;
}

std::vector<std::string> cross_check(LoadedConfig const& loaded) {
    std::vector<std::string> complaints;
    for (std::size_t index = 0; index < fifo_count; ++index) {
        check_write_latency(loaded, FifoId{index}, complaints);
    }
    for (std::size_t index = 0; index < bram_count; ++index) {
        check_partition(loaded, BramId{index}, complaints);
    }
    check_lanes(loaded, complaints);
    check_scan_lanes(loaded, complaints);
    check_sweep_region(loaded, complaints);
    check_fraction_bits(loaded, complaints);
    check_scan(loaded, complaints);
    check_edge_tokens(loaded, complaints);
    check_neighbourhood(loaded, complaints);
    check_edge_extraction(loaded, complaints);
    check_parts(loaded, complaints);
    return complaints;
}

}  // namespace faster
