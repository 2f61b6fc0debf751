#pragma once
#include <cstddef>
#include <optional>

#include "faster/config/edge_extraction_config.hpp"
#include "faster/config/edge_map_config.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/reference/depth_buffer.hpp"
#include "faster/reference/inlier_sweep.hpp"
#include "faster/reference/vertex_transform.hpp"

namespace faster::reference {

/// Scores the samples of a stimulus in any order: everything of docs/function.md, without any notion of time. Buffers
/// are kept between samples. The stimulus is held by reference and must not change.
class Scorer {
  public:
    /// `edge_map`: the keys accelerator.edge_map.*. Throws InputError if the stimulus does not hang
    /// together (a window below 1 px, images of another size, a triangle range outside, poses missing) or its fraction
    /// bits need more than 128 bit arithmetic.
    explicit Scorer(Stimulus const& stimulus, EdgeMapConfig const& edge_map = {});

    /// Flow fpga_grip: edges of the finished depth buffer. Throws as above.
    Scorer(Stimulus const& stimulus, EdgeExtractionConfig const& edge_extraction);

    /// From now on, hidden pixels too; key accelerator.inlier_unit.hidden.
    void count_hidden() { counts_hidden_ = true; }

    /// Scores one sample; throws std::out_of_range if there is no such sample.
    SampleCounters run(std::size_t sample);

    /// The W x W pictures of the last sample run; overwritten by the next.
    SampleMaps const& maps() const { return maps_; }

  private:
    struct TriangleRange {
        TriangleCode const* first;
        TriangleCode const* last;
        TriangleCode const* begin() const { return first; }
        TriangleCode const* end() const { return last; }
    };

    TriangleRange triangles_of(std::size_t sample);
    template <class Builder, class Tokens> SampleCounters run_with(std::size_t sample, Tokens tokens);

    Stimulus const& stimulus_;
    EdgeMapConfig edge_map_;
    std::optional<EdgeExtractionConfig> edge_extraction_;  // of flow fpga_grip
    bool counts_hidden_ = false;
    FragmentDepth fragment_depth_;
    std::optional<VertexTransform> vertex_transform_;  // of a posed stimulus
    SampleMaps maps_;
    ObservedWindow observed_;
};

}  // namespace faster::reference
