#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "support/parts.hpp"

namespace faster::testing {

/// A pixel relative to the window; may lie outside it.
struct TwinPixel {
    int row = 0;
    int col = 0;
};

/// A word of a memory that an iteration reads, or writes if that happens.
struct TwinTouch {
    BramId bram = BramId::edge_map;
    TwinPixel pixel;
    bool writes = false;
};
/// All that the iterations of a loop touch, in its order.
using TwinTouches = std::vector<std::vector<TwinTouch>>;

struct TwinEdgeToken {
    TwinPixel pixel;
    bool is_object = false;
};

/// One iteration of the rasterizer's scan: a flush sends an edge token only, a visit of a pixel or a group sends
/// a fragment, an edge token, both or nothing.
struct TwinScanIteration {
    bool sends_fragment = false;
    bool sends_edge_token = false;
    int row = -1;     ///< of a visit; a flush belongs to none
    int group = 0;    ///< of a visit, in its row: of as many pixels as there are lanes
    int covered = 0;  ///< pixels of a visit
};

struct TwinTriangle {
    std::int64_t area_code = 0;  ///< 0 for a rejected one
    bool is_drawn = false;
    std::vector<TwinScanIteration> scan;  ///< empty unless drawn
    std::uint64_t fragments = 0;          ///< tokens: with several lanes, groups that have a covered pixel
};

/// Pixels of the window: rows [first_row, end_row), columns [first_col, end_col).
struct TwinRegion {
    std::size_t first_row = 0;
    std::size_t end_row = 0;
    std::size_t first_col = 0;
    std::size_t end_col = 0;
};

/// The function of docs/function.md for one sample, from triangle codes to counters, with the counts that decide the
/// control flow of section 3.
struct TwinSampleFunction {
    std::vector<TwinTriangle> triangles;
    std::vector<bool> token_iteration_reads;  ///< one per iteration of the token loop; false for second iterations
    TwinTouches token_touches;                ///< of those; empty if each token holds a group
    TwinTouches fragment_touches;             ///< of fragment tokens, of all triangles
    bool output_reads_ahead = false;          ///< the output loop has read a row when it sends the first bit
    TwinRegion region;                        ///< that the loops behind the drawing go over
    SampleCounters counters;
};

TwinSampleFunction evaluate_sample(Stimulus const& stimulus, std::size_t sample, AcceleratorConfig const& config);

}  // namespace faster::testing
