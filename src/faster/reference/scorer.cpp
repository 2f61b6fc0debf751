#include "faster/reference/scorer.hpp"

#include <cstdint>
#include <string>

#include "dataflow/base/enumerators.hpp"
#include "dataflow/base/input_error.hpp"
#include "faster/dataflow_names.hpp"
#include "faster/reference/edge_extraction.hpp"
#include "faster/reference/edge_map/bounded.hpp"
#include "faster/reference/edge_map/dual_map.hpp"
#include "faster/reference/edge_map/dual_map_4_1_2.hpp"
#include "faster/reference/edge_map/edge_map_builder.hpp"
#include "faster/reference/edge_map/inner_border.hpp"
#include "faster/reference/edge_map/threshold.hpp"
#include "faster/reference/edge_map/transition.hpp"
#include "faster/reference/edge_tokens.hpp"
#include "faster/reference/inlier_sweep.hpp"
#include "faster/reference/rasterize.hpp"

namespace faster::reference {
namespace {

template <class Pixel> void check_size(char const* name, Image<Pixel> const& image, Stimulus const& stimulus) {
    if (image.height() != stimulus.height || image.width() != stimulus.width) {
        throw InputError("stimulus: " + std::string(name) + " is " + std::to_string(image.width()) + " x " +
                         std::to_string(image.height()) + ", expected " + std::to_string(stimulus.width) + " x " +
                         std::to_string(stimulus.height));
    }
}

void check_triangles(Stimulus const& stimulus) {
    for (std::size_t i = 0; i < stimulus.samples.size(); ++i) {
        SampleInput const& sample = stimulus.samples[i];
        if (std::uint64_t{sample.first_triangle} + sample.triangle_count > stimulus.triangles.size()) {
            throw InputError("stimulus: sample " + std::to_string(i) + " has " + std::to_string(sample.triangle_count) +
                             " triangles from " + std::to_string(sample.first_triangle) + " on, expected at most " +
                             std::to_string(stimulus.triangles.size()) + " in all");
        }
    }
}

void check(Stimulus const& stimulus) {
    if (stimulus.window < 1) {
        throw InputError("stimulus: window = " + std::to_string(stimulus.window) + " px, expected at least 1");
    }
    check_size("observed_depth", stimulus.observed_depth, stimulus);
    check_size("observed_edges", stimulus.observed_edges, stimulus);
    if (!stimulus.is_posed()) {
        check_triangles(stimulus);
    } else if (stimulus.posed.poses.size() != stimulus.samples.size()) {
        throw InputError("stimulus: " + std::to_string(stimulus.posed.poses.size()) +
                         " poses, expected one for each of " + std::to_string(stimulus.samples.size()) + " samples");
    }
}

// Receives what the rasterizer finds, in image coordinates, and hands it on in those of the window. What lies outside
// the window is dropped.
template <class EdgeMapBuilder> class WindowSink {
  public:
    WindowSink(WindowOffset offset, int window, FragmentDepth& fragment_depth, DepthBuffer& depth_buffer,
               EdgeMapBuilder& edge_map_builder)
        : offset_(offset),
          window_(window),
          fragment_depth_(fragment_depth),
          depth_buffer_(depth_buffer),
          edge_map_builder_(edge_map_builder) {}

    void triangle(std::int64_t area_code) { fragment_depth_.set_area(area_code); }

    void fragment(Pixel pixel, std::int64_t z_sum) {
        if (contains(pixel)) {
            depth_buffer_.draw(row(pixel), col(pixel), fragment_depth_.of(z_sum));
        }
    }

    void object(Pixel pixel) {
        edge_map_builder_.next_token();
        if (contains(pixel)) {
            edge_map_builder_.object(row(pixel), col(pixel));
        }
    }

    void edge(Pixel pixel) {
        edge_map_builder_.next_token();
        if (contains(pixel)) {
            edge_map_builder_.edge(row(pixel), col(pixel));
        }
    }

  private:
    bool contains(Pixel pixel) const {
        return pixel.row >= offset_.row && pixel.row < offset_.row + window_ && pixel.col >= offset_.col &&
               pixel.col < offset_.col + window_;
    }
    int row(Pixel pixel) const { return static_cast<int>(pixel.row - offset_.row); }
    int col(Pixel pixel) const { return static_cast<int>(pixel.col - offset_.col); }

    WindowOffset offset_;
    int window_;
    FragmentDepth& fragment_depth_;
    DepthBuffer& depth_buffer_;
    EdgeMapBuilder& edge_map_builder_;
};

}  // namespace

Scorer::Scorer(Stimulus const& stimulus, EdgeMapConfig const& edge_map)
    : stimulus_(stimulus), edge_map_(edge_map), fragment_depth_(stimulus.fraction) {
    check(stimulus);
    int const window = stimulus.window;
    maps_ = {{window, window}, {window, window}, {window, window}};
    observed_ = {{window, window}, {window, window}};
    if (stimulus.is_posed()) {
        vertex_transform_.emplace(stimulus.posed.mesh, stimulus.posed.camera, stimulus.fraction);
    }
}

Scorer::Scorer(Stimulus const& stimulus, EdgeExtractionConfig const& edge_extraction) : Scorer(stimulus) {
    edge_extraction_ = edge_extraction;
}

SampleCounters Scorer::run(std::size_t sample) {
    if (edge_extraction_) {
        return run_with<EdgeMapBuilder>(sample, NoTokens());
    }
    switch (edge_map_.algorithm) {
        case EdgeMapAlgorithm::threshold:
            return run_with<Threshold>(sample, NearEdgeTokens(edge_map_.thresholds, stimulus_.fraction.vertex_xy));
        case EdgeMapAlgorithm::transition:
            return run_with<Transition>(sample, TransitionTokens());
        case EdgeMapAlgorithm::bounded:
            return run_with<Bounded>(sample, TransitionTokens());
        case EdgeMapAlgorithm::dual_map_4_1_2:
            return run_with<DualMapFirstWrite>(sample, TransitionTokens());
        case EdgeMapAlgorithm::inner_border:
            return run_with<InnerBorder>(sample, TransitionTokens());
        case EdgeMapAlgorithm::dual_map:
            return run_with<DualMap>(sample, TransitionTokens());
        default:  // of a design that is being tried
            throw InputError(
                "accelerator.edge_map.algorithm = " + std::string(dataflow::enumerator_name(edge_map_.algorithm)) +
                ", which the reference does not build");
    }
}

template <class Builder, class Tokens> SampleCounters Scorer::run_with(std::size_t sample, Tokens tokens) {
    SampleInput const& input = stimulus_.samples.at(sample);
    WindowOffset const offset{stimulus_.window_offset(input.centre_row), stimulus_.window_offset(input.centre_col)};
    DepthBuffer depth_buffer(maps_.depth_buffer, stimulus_.fraction);
    Builder edge_map_builder(maps_.edge_map, maps_.object_map);
    WindowSink sink(offset, stimulus_.window, fragment_depth_, depth_buffer, edge_map_builder);
    for (TriangleCode const& triangle : triangles_of(sample)) {
        rasterize(triangle, stimulus_.width, stimulus_.height, stimulus_.fraction.vertex_xy, tokens, sink);
    }
    edge_map_builder.end(edge_map_.flush_last);
    if (edge_extraction_) {
        extract_edges(*edge_extraction_, stimulus_.fraction.depth_buffer, maps_);
    }

    SampleCounters counters;
    counters.valid_raster = depth_buffer.valid_raster();
    read_window(stimulus_, offset, observed_);
    EdgeDepth const edge_depth = edge_extraction_ || edge_map_.algorithm == EdgeMapAlgorithm::inner_border
                                     ? EdgeDepth::of_pixel
                                     : EdgeDepth::of_neighbour;
    sweep(maps_, observed_, stimulus_.fraction.depth_buffer, edge_depth, counters);
    if (counts_hidden_) {
        reference::count_hidden(maps_.depth_buffer, observed_.depth, stimulus_.fraction.depth_buffer, counters);
    }
    return counters;
}

Scorer::TriangleRange Scorer::triangles_of(std::size_t sample) {
    if (vertex_transform_) {
        std::vector<TriangleCode> const& triangles = (*vertex_transform_)(stimulus_.posed.poses[sample]);
        return {triangles.data(), triangles.data() + triangles.size()};
    }
    SampleInput const& input = stimulus_.samples[sample];
    TriangleCode const* const first = stimulus_.triangles.data() + input.first_triangle;
    return {first, first + input.triangle_count};
}

}  // namespace faster::reference
