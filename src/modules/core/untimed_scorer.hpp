#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "faster/config/edge_map_config.hpp"
#include "faster/config/inlier_unit_config.hpp"
#include "faster/data/stimulus.hpp"
#include "modules/core/depth.hpp"
#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"
#include "modules/inlier_unit/hidden_pixels.hpp"
#include "modules/inlier_unit/valid_depth_table.hpp"
#include "modules/inlier_unit/window_sweep.hpp"
#include "modules/rasterizer/zigzag_scan.hpp"
#include "modules/vertex_transform/project_vertices.hpp"

namespace faster::datapath {

/// Where the window of a sample lies, and how many pixels it has a side.
struct Window {
    std::int64_t row = 0;  ///< of its first pixel in the image
    std::int64_t col = 0;
    int side = 0;
};

/// The counters of a pose, without time: what the modules of a core compute, a pixel run at a time. For flow `faster`,
/// whatever the edge map's algorithm but `threshold`, whose tokens lie elsewhere.
class UntimedScorer {
  public:
    static bool scores(EdgeMapAlgorithm algorithm) { return algorithm != EdgeMapAlgorithm::threshold; }

    /// `stimulus`: a posed one, held by reference; its mesh, camera and observation must not change, its samples may.
    UntimedScorer(Stimulus const& stimulus, EdgeMapConfig const& edge_map, HiddenPixels hidden = HiddenPixels::ignored);

    SampleCounters score(Pose const& pose, SampleInput const& input);

    /// Of the last sample.
    EdgeMapPolicy const& edge_maps() const { return *maps_; }
    std::vector<std::uint16_t> const& depth_buffer() const { return depth_buffer_; }

  private:
    /// All triangles, their tokens in the order in which they are sent.
    template <class Maps> void draw_mesh(Maps& maps, SampleCounters& counters);
    /// Draws all triangles into maps that do not depend on the order of tokens, but for the last one.
    template <class Maps> void draw_mesh_in_any_order(Maps& maps, SampleCounters& counters);
    void clear_drawn_rows();
    TriangleSetup set_up_face(std::size_t face) const;
    std::size_t last_face_with_tokens() const;
    bool holds(TriangleSetup const& setup) const;
    void begin(TriangleSetup const& setup);
    template <class Maps> void draw(TriangleSetup const& setup, Maps& maps, SampleCounters& counters);
    template <class Maps> void draw_in_any_order(TriangleSetup const& setup, Maps& maps, SampleCounters& counters);
    std::uint64_t draw_run(ScanLine const& line, std::uint64_t reciprocal);
    template <class Maps> void add_tokens(ScanLine const& line, Maps& maps);
    template <class Maps> void add_token(int row, int col, EdgeTokenKind kind, Maps& maps);
    template <class Maps> void add_run(int row, int first_col, int last_col, int step, Maps& maps);
    void sweep(SampleCounters& counters);
    void sweep_row(int row, SampleCounters& counters);

    Stimulus const& stimulus_;
    EdgeMapConfig edge_map_;
    DepthUnit depth_unit_;
    WindowSweep sweep_;
    std::optional<HiddenSweep> hidden_sweep_;
    ValidDepthTable valid_depths_;
    std::unique_ptr<EdgeMapPolicy> maps_;
    std::vector<ProjectedVertex> vertices_;
    std::vector<std::uint16_t> depth_buffer_;
    std::vector<std::uint16_t> depth_row_;  ///< of the observation, where the window leaves the image
    std::vector<std::uint8_t> edge_row_;
    Window window_;
    int first_drawn_row_ = 0;  ///< of the window; what is drawn and its contour lie in [first, end)
    int end_drawn_row_ = 0;
    EdgeToken token_;  ///< the last one so far
    bool has_token_ = false;
    // Of the scan, as it enters a line: the pixel before, in the window, and whether it was inside.
    bool previous_inside_ = false;
    int previous_row_ = 0;
    int previous_col_ = 0;
};

}  // namespace faster::datapath
