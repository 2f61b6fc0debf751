#pragma once
#include <cstddef>
#include <optional>

#include "faster/config/edge_map_config.hpp"
#include "faster/data/image.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/reference/vertex_transform.hpp"
#include "poses/quality/contour_quality.hpp"

namespace faster::quality {

/// Sums of the qualities of many edge maps.
struct QualitySums {
    std::size_t poses = 0;
    double precision = 0;
    double recall = 0;
    double thickness = 0;
    std::size_t closed = 0;
    std::size_t thin = 0;
    std::size_t closed_and_thin = 0;

    void add(ContourQuality const& quality) {
        poses += 1;
        precision += quality.precision;
        recall += quality.recall;
        thickness += quality.thickness;
        closed += quality.is_closed ? 1 : 0;
        thin += quality.is_thin ? 1 : 0;
        closed_and_thin += quality.is_closed && quality.is_thin ? 1 : 0;
    }

    void include(QualitySums const& other) {
        poses += other.poses;
        precision += other.precision;
        recall += other.recall;
        thickness += other.thickness;
        closed += other.closed;
        thin += other.thin;
        closed_and_thin += other.closed_and_thin;
    }

    /// Of one of the sums; 0 without poses.
    double mean(double sum) const { return poses > 0 ? sum / static_cast<double>(poses) : 0; }
    double share(std::size_t count) const { return mean(static_cast<double>(count)); }
};

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
