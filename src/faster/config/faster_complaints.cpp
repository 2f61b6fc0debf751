#include "faster/config/faster_complaints.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dataflow/run/config/config_sources.hpp"
#include "dataflow/run/config/external_memory_keys.hpp"
#include "faster/config/faster_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {
namespace {

constexpr char const* area_reciprocal_key = "accelerator.fraction_bits.area_reciprocal";
constexpr char const* vertex_xy_key = "accelerator.fraction_bits.vertex_xy";
constexpr int most_reciprocal_bits = 62;  ///< 2^(area_reciprocal + 2 * vertex_xy) and what it divides fit 63 bits

void check_fraction_bits(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    FractionBits const& bits = accelerator_of(loaded.config).fraction_bits;
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
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
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
    AcceleratorConfig const& accelerator = accelerator_of(loaded.config);
    if (accelerator.rasterizer.edge_tokens == EdgeTokens::all || accelerator.flow != Flow::faster ||
        accelerator.edge_map.algorithm == EdgeMapAlgorithm::inner_border)
        return;
    complaints.push_back(
        complaint(loaded, "accelerator.rasterizer.edge_tokens",
                  fmt::format("all because of {}", with_value(loaded, "accelerator.edge_map.algorithm"))));
}

void check_lanes(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    AcceleratorConfig const& config = accelerator_of(loaded.config);
    if (config.inlier_unit.sweep_lanes > config.window) {
        complaints.push_back(complaint(loaded, "accelerator.inlier_unit.sweep_lanes",
                                       fmt::format("at most {}", with_value(loaded, "accelerator.window"))));
    }
}

/// Tokens of several pixels say which are covered, and nothing of those beside a triangle.
void check_scan_lanes(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    constexpr char const* lanes_key = "accelerator.rasterizer.lanes";
    AcceleratorConfig const& config = accelerator_of(loaded.config);
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

constexpr int most_bits_with_far = 9;  ///< of the depth buffer: 2 m is code 1024 then, far is 2047

/// Where nothing is drawn the depth buffer says "far", which has to lie beyond the 2 m up to which the sweep compares.
/// The touched region and hidden pixels rely on it.
void check_far(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    AcceleratorConfig const& config = accelerator_of(loaded.config);
    if (config.fraction_bits.depth_buffer <= most_bits_with_far)
        return;
    auto const complain = [&](char const* key, char const* instead, char const* did) {
        complaints.push_back(
            complaint(loaded, key,
                      fmt::format("{} because of {}, with which pixels that nothing {} are nearer than 2 m", instead,
                                  with_value(loaded, "accelerator.fraction_bits.depth_buffer"), did)));
    };
    if (config.inlier_unit.sweep_region == SweepRegion::touched)
        complain("accelerator.inlier_unit.sweep_region", "window", "touched");
    if (counts_hidden(config.inlier_unit))
        complain("accelerator.inlier_unit.hidden", "ignored", "drew");
}

void check_odd(LoadedConfig const& loaded, char const* key, int value, std::vector<std::string>& complaints) {
    if (value % 2 == 0)
        complaints.push_back(complaint(loaded, key, "an odd number"));
}

void check_observation_copies(LoadedConfig const& loaded, std::vector<std::string>& complaints) {
    AcceleratorConfig const& config = accelerator_of(loaded.config);
    if (config.external_memory.model == MemoryModel::axi && config.memory_placement.observation_copies > config.cores)
        complaints.push_back(complaint(loaded, "accelerator.memory.observation_copies",
                                       fmt::format("at most {}", with_value(loaded, "accelerator.raster_cores"))));
}

/// Eq. 2.4: the coefficients add up to 1. Decimal fractions hardly do so exactly.
void check_weights(LoadedConfig const& loaded, char const* backend, std::vector<std::string> const& names,
                   WeightCoefficients const& weights, std::vector<std::string>& complaints) {
    constexpr double tolerance = 1e-9;
    if (estimator_of(loaded.config).in_box == InBoxTerm::none && weights.in_box == 1)
        complaints.push_back(complaint(loaded, fmt::format("estimator.weights.{}.in_box", backend),
                                       "less than 1 with estimator.weights.in_box none, which leaves it out"));
    double const sum = weights.box + weights.in_box + weights.raw + weights.edge + weights.planar;
    if (std::abs(sum - 1) <= tolerance)
        return;
    std::string const section = fmt::format("estimator.weights.{}", backend);
    auto const is_given = [&](std::string const& name) { return loaded.origins.is_explicit(section + "." + name); };
    auto const given = std::find_if(names.begin(), names.end(), is_given);
    complaints.push_back(complaint(
        loaded, section + "." + (given == names.end() ? names.front() : *given),
        fmt::format("coefficients {} of {} that add up to 1, not to {:.10g}", fmt::join(names, ", "), section, sum)));
}

}  // namespace

std::vector<std::string> faster_complaints(LoadedConfig const& loaded) {
    std::vector<std::string> complaints;
    check_lanes(loaded, complaints);
    check_scan_lanes(loaded, complaints);
    check_far(loaded, complaints);
    check_fraction_bits(loaded, complaints);
    check_scan(loaded, complaints);
    check_edge_tokens(loaded, complaints);
    check_odd(loaded, "workload.observed_edges.neighbourhood", workload_of(loaded.config).observed_edges.neighbourhood,
              complaints);
    check_odd(loaded, "accelerator.edge_extraction.neighbourhood",
              accelerator_of(loaded.config).edge_extraction.neighbourhood, complaints);
    check_observation_copies(loaded, complaints);
    for (std::string const& complaint : external_memory_complaints(loaded))
        complaints.push_back(complaint);
    EstimatorConfig const& estimator = estimator_of(loaded.config);
    check_weights(loaded, "accelerator", {"box", "in_box", "raw", "edge"}, estimator.accelerator_weights, complaints);
    check_weights(loaded, "grip", {"box", "in_box", "raw", "edge", "planar"}, estimator.grip_weights, complaints);
    return complaints;
}

}  // namespace faster
