#include "modules/edge_extractor/edge_extractor.hpp"

#include <algorithm>

#include "faster/config/extract_design.hpp"

namespace faster {

EdgeExtractor::EdgeExtractor(CoreContext const& core, ProcessClock& clock)
    : core_(core),
      clock_(clock),
      extraction_(core.config.edge_extraction, core.stimulus.window, core.stimulus.fraction.depth_buffer),
      edges_(core.window_pixels()) {}

void EdgeExtractor::extract(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer, PixelBox const& box) {
    extraction_.extract(depth_buffer, edges_);
    if (core_.probe != nullptr)
        show(sample, depth_buffer);
    if (box.empty()) {
        clock_.advance(1);
        return;
    }
    auto const cols = static_cast<std::size_t>(box.cols());
    clock_.pipeline("extract", static_cast<std::size_t>(box.rows()) * cols + extract_design(core_.config).lead(cols));
}

/// There is no object map: what is drawn stands in the depth buffer.
void EdgeExtractor::show(std::size_t sample, std::vector<std::uint16_t> const& depth_buffer) const {
    std::vector<std::uint8_t> drawn(depth_buffer.size());
    std::transform(depth_buffer.begin(), depth_buffer.end(), drawn.begin(),
                   [this](std::uint16_t depth) { return extraction_.is_drawn(depth) ? 1 : 0; });
    core_.probe->edge_maps_done(sample, {edges_.data(), drawn.data(), core_.stimulus.window});
}

}  // namespace faster
