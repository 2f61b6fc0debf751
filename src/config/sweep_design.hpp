#pragma once
#include <cstddef>

#include "config/accelerator_config.hpp"
#include "config/access_pattern.hpp"

namespace faster {

/// What the sweep of the inlier unit asks of the depth buffer. docs/timing-model.md tells how the numbers come about.
struct SweepDesign {
    AccessPattern accesses;  ///< of an iteration
    std::size_t lead = 0;    ///< iterations before the first pixel is judged: the line buffers fill
    std::size_t tail = 0;    ///< iterations after the last: what nobody reads any more is cleared
    bool has_line_buffers = false;
};

/// `window`: side of the window [px], which a stimulus trace decides.
SweepDesign sweep_design(AcceleratorConfig const& config, int window);

}  // namespace faster
