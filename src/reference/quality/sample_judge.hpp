#pragma once
#include <cstddef>
#include <optional>

#include "common/edge_map_config.hpp"
#include "common/image.hpp"
#include "common/stimulus.hpp"
#include "reference/quality/contour_quality.hpp"
#include "reference/vertex_transform.hpp"

namespace faster::quality {

/// Which contour an algorithm is to draw.
ContourSide side_of(EdgeMapAlgorithm algorithm);

/// Judges edge maps of the samples of a stimulus, posed or traced, by the silhouettes of their triangles. The stimulus
/// is held by reference and must not change.
class SampleJudge {
  public:
    SampleJudge(Stimulus const& stimulus, ContourSide side);

    /// `edge_map`: 0 or 1, W x W
    ContourQuality judge(std::size_t sample, Image<std::uint8_t> const& edge_map);

    /// The pixels that the sample's triangles cover, 0 or 1, W x W.
    Image<std::uint8_t> silhouette_of(std::size_t sample);

  private:
    Stimulus const& stimulus_;
    ContourSide side_;
    std::optional<reference::VertexTransform> transform_;  // of a posed stimulus
};

}  // namespace faster::quality
