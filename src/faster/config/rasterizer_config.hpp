#pragma once
#include <cstdint>

namespace faster {

/// Which pixels of a triangle's box the scan visits; key `accelerator.rasterizer.scan`. All find the same covered
/// pixels, and send the same edge tokens in the same order.
enum class ScanPolicy {
    zigzag,      ///< all of them, wall to wall: what thesis A.1 does
    early_exit,  ///< leaves a line where nothing covered can follow in it or in the next: what A.1's flags are for
    spans,       ///< works out where the covered run of a line begins and ends, and visits only that
};

/// Which tokens the edge map builder gets; key `accelerator.rasterizer.edge_tokens`.
enum class EdgeTokens {
    all,     ///< of covered pixels, and of those where the scan enters and leaves a triangle (thesis A.1)
    object,  ///< of covered pixels only: all that `inner_border` looks at
};

/// How triangles are prepared and scanned; keys `accelerator.rasterizer.*`. None of them changes a result.
struct RasterizerConfig {
    ScanPolicy scan = ScanPolicy::zigzag;
    /// Triangles whose vertices are read ahead of the scan, in one loop per sample; 0: a triangle is prepared, then
    /// scanned by a loop of its own (thesis A.1)
    std::uint64_t setup_overlap = 0;
    EdgeTokens edge_tokens = EdgeTokens::all;
    /// Adjacent pixels of a row that an iteration of the scan tests and a token of it holds, 1 to most_scan_lanes
    int lanes = 1;
};

/// A group's covered pixels are the bits of a word.
constexpr int most_scan_lanes = 32;

}  // namespace faster
