#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "faster/data/camera.hpp"
#include "faster/data/fixed_point.hpp"
#include "faster/data/image.hpp"
#include "faster/data/mesh.hpp"
#include "faster/data/tokens.hpp"

namespace faster {

/// One pose sample as the machine gets it.
struct SampleInput {
    std::int32_t centre_row = 0;  ///< pixel row of the projected object origin
    std::int32_t centre_col = 0;
    std::uint32_t first_triangle = 0;  ///< into Stimulus::triangles; unused for posed meshes
    std::uint32_t triangle_count = 0;
};

/// A mesh seen under one pose per sample: the vertex transform is still to be done.
struct PosedMesh {
    Mesh mesh;
    Camera camera;
    std::vector<Pose> poses;  ///< one per sample
};

/// Everything that determines what the machine computes (docs/formats.md#stimulus-trace). The triangles come either as
/// codes after the vertex transform (`triangles`, a trace) or as a mesh under a pose per sample (`posed`, not empty of
/// poses): never both.
struct Stimulus {
    int width = 640;  ///< image [px]
    int height = 480;
    int window = 200;  ///< side of the square around a sample's centre [px]
    FractionBits fraction;
    std::vector<SampleInput> samples;
    std::vector<TriangleCode> triangles;
    PosedMesh posed;
    Image<std::uint16_t> observed_depth;  ///< height x width, codes 0..far_depth_code, 0 = no reading
    Image<std::uint8_t> observed_edges;   ///< height x width, 0 or 1

    bool is_posed() const { return !posed.poses.empty(); }
    /// Where the window of a sample begins whose centre is in this row, or column (docs/function.md#samples-and-cores).
    std::int64_t window_offset(std::int32_t centre) const { return std::int64_t{centre} - window / 2; }
    static constexpr std::int64_t furthest_window = 28000;  ///< px, with an image of 4096 px at most
    /// Token coordinates have 16 bits, so a window that begins further off than that lies about there instead, with the
    /// same columns for each lane: it covers no pixel either way.
    int near_window_offset(std::int32_t centre, int lanes = 1) const {
        std::int64_t const offset = window_offset(centre);
        std::int64_t const beyond = offset - std::clamp(offset, -furthest_window, furthest_window);
        return static_cast<int>(offset - beyond + beyond % lanes);
    }
};

/// What one sample leaves behind, for comparing model and reference: W x W pictures of its window.
struct SampleMaps {
    Image<std::uint8_t> edge_map;       ///< 0 or 1
    Image<std::uint8_t> object_map;     ///< 0 or 1
    Image<std::uint16_t> depth_buffer;  ///< codes
};

}  // namespace faster
