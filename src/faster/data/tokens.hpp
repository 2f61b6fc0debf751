#pragma once
#include <cstddef>
#include <cstdint>

#include "faster/data/sample_counters.hpp"

namespace faster {

/// One vertex after the vertex transform, as raw codes (formats: FractionBits).
struct VertexCode {
    std::int16_t x = 0;   ///< column
    std::int16_t y = 0;   ///< row, downwards
    std::uint16_t z = 0;  ///< depth
    friend bool operator==(VertexCode const& a, VertexCode const& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
};

/// Three vertices, counter-clockwise seen from outside the object.
struct TriangleCode {
    VertexCode vertex[3];
    friend bool operator==(TriangleCode const& a, TriangleCode const& b) {
        return a.vertex[0] == b.vertex[0] && a.vertex[1] == b.vertex[1] && a.vertex[2] == b.vertex[2];
    }
};

/// What the dispatcher tells the stages of a core about one sample; tokens of sample_vertex, sample_raster and
/// sample_observation.
struct SampleHeader {
    std::uint32_t sample = 0;     ///< index over all cores
    std::int32_t centre_row = 0;  ///< floor of the projected object origin
    std::int32_t centre_col = 0;
    std::uint32_t triangles = 0;  ///< number of triangles of the sample
};

/// Tokens of `command` (thesis A.1: Read_area, Read_d_i, End_raster).
enum class Command : std::uint8_t { Triangle, Fragment, End };
constexpr char const* command_names = "triangle fragment end";

/// Token of `fragment_index`: the pixel of a fragment, relative to the window; may lie outside it.
struct FragmentIndex {
    std::int16_t row = 0;
    std::int16_t col = 0;
};

/// Tokens of `fragment_index` and `edge_token` with several `rasterizer.lanes`: covered pixels of a row. Bit k of
/// `mask` is column col + k, relative to the window; pixels may lie outside it. An empty mask in `edge_token` closes
/// the sample.
struct PixelGroup {
    std::int16_t row = 0;
    std::int16_t col = 0;
    std::uint32_t mask = 0;
};

/// Token of `fragment_depth` with several lanes: the z sum of a group's first column, covered or not, and what each
/// column to the right adds.
struct DepthGroup {
    std::int64_t z_sum = 0;
    std::int64_t z_sum_per_column = 0;
};

/// What an edge token says of its pixel; `End` closes the sample.
enum class EdgeTokenKind : std::int32_t { Edge, Object, End };
constexpr char const* edge_token_kind_names = "edge object end";

/// Token of `edge_token` (thesis: edge_position). Coordinates are relative to the window and may lie outside it.
struct EdgeToken {
    std::int16_t row = 0;
    std::int16_t col = 0;
    EdgeTokenKind kind = EdgeTokenKind::Edge;
};

}  // namespace faster
