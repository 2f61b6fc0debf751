#pragma once
#include <cstdint>
#include <vector>

#include "faster/config/edge_extraction_config.hpp"

namespace faster::datapath {

/// Edges of a depth buffer by thesis eq. 2.2 in fixed point (formats: docs/modules/edge_extractor.md),
///   c = || sum over N of (p' - p) || / (|N| * ||p||) > threshold,
/// as hardware with line buffers sums it up: column by column. The point p of a pixel is its depth times the slopes of
/// the ray through it, counted from the window's centre. N: the other pixels of the n x n square in the window; where
/// nothing is drawn the depth is "far". Only drawn pixels (below 2 m) are edges.
class EdgeExtraction {
  public:
    EdgeExtraction(EdgeExtractionConfig const& config, int window, int depth_fraction);

    /// `depth_buffer`: W x W codes, row-major. Sets `edges`, W x W, to 0 or 1.
    void extract(std::vector<std::uint16_t> const& depth_buffer, std::vector<std::uint8_t>& edges);

    /// Whether something is drawn in a pixel of that depth.
    bool is_drawn(std::uint16_t depth) const { return depth < near_limit_; }

  private:
    struct Vector {
        std::int64_t x = 0, y = 0, z = 0;
    };
    void add_row(std::vector<std::uint16_t> const& depth_buffer, int row, std::int64_t sign);
    void extract_row(std::uint16_t const* depth, int row, std::uint8_t* edges) const;
    Vector point(std::int64_t depth, int row, int col) const;
    Vector sum_around(int first_col, int end_col) const;
    bool is_edge(Vector const& point, Vector const& sum, std::int64_t pixels) const;
    int first(int position) const;
    int end(int position) const;

    int window_;
    int radius_;
    unsigned near_limit_;
    std::uint64_t threshold_code_;
    std::vector<std::int64_t> slope_;   ///< of rows and columns alike, s18.15
    std::vector<std::int64_t> depths_;  ///< per column, over the rows around the one at hand: depth codes
    std::vector<std::int64_t> ys_;      ///< depth codes times slopes
};

}  // namespace faster::datapath
