#pragma once
#include <vector>

#include "channels/process_clock.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/edge_extractor/edge_extraction.hpp"

namespace faster {

/// The inlier unit's part that flow fpga_grip has in place of the edge map builder: once a sample is drawn, it looks
/// for edges in the depth buffer, and keeps an edge bit in each of its words.
///   time  loop `extract` of the inlier unit's process, one pixel per iteration
/// Source: thesis eq. 2.2 and 6.2; docs/variants.md.
class EdgeExtractor {
  public:
    EdgeExtractor(CoreContext const& core, ProcessClock& clock);
    /// `box`: the pixels looked at; nothing is drawn outside.
    void extract(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer, PixelBox const& box);
    /// W x W bits of the sample extracted last, row-major.
    std::uint8_t const* edges() const { return edges_.data(); }

  private:
    void show(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) const;

    CoreContext const& core_;
    ProcessClock& clock_;
    datapath::EdgeExtraction extraction_;
    std::vector<std::uint8_t> edges_;
};

}  // namespace faster
