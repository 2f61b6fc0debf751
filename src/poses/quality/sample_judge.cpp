#include "poses/quality/sample_judge.hpp"

#include <vector>

#include "poses/quality/silhouette.hpp"

namespace faster::quality {

ContourSide side_of(EdgeMapAlgorithm algorithm) {
    return contour_is_on_object(algorithm) ? ContourSide::inside : ContourSide::outside;
}

SampleJudge::SampleJudge(Stimulus const& stimulus, ContourSide side) : stimulus_(stimulus), side_(side) {
    if (stimulus.is_posed())
        transform_.emplace(stimulus.posed.mesh, stimulus.posed.camera, stimulus.fraction);
}

ContourQuality SampleJudge::judge(std::size_t sample, Image<std::uint8_t> const& edge_map) {
    return contour_quality(edge_map, silhouette_of(sample), side_);
}

Image<std::uint8_t> SampleJudge::silhouette_of(std::size_t sample) {
    SampleInput const& input = stimulus_.samples.at(sample);
    if (transform_)
        return silhouette((*transform_)(stimulus_.posed.poses.at(sample)), stimulus_, input);
    auto const first = stimulus_.triangles.begin() + static_cast<std::ptrdiff_t>(input.first_triangle);
    return silhouette({first, first + static_cast<std::ptrdiff_t>(input.triangle_count)}, stimulus_, input);
}

}  // namespace faster::quality
