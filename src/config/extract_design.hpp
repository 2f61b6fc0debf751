#pragma once
#include <cstddef>
#include <cstdint>

#include "config/accelerator_config.hpp"
#include "config/access_pattern.hpp"

namespace faster {

/// What inlier_unit.extract (flow fpga_grip) asks of the depth buffer. docs/timing-model.md tells how the numbers come
/// about.
struct ExtractDesign {
    AccessPattern accesses;              ///< of an iteration: what it reads, and the judged word with its edge bit
    std::size_t lead = 0;                ///< iterations before the first pixel is judged: the line buffers fill
    std::uint64_t line_buffer_rows = 0;  ///< kept beside the depth buffer
};

/// `window`: side of the window [px], which a stimulus trace decides.
ExtractDesign extract_design(AcceleratorConfig const& config, int window);

}  // namespace faster
