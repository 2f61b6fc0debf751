#pragma once
#include <cstddef>
#include <cstdint>

#include "config/accelerator_config.hpp"

namespace faster {

/// What inlier_unit.extract (flow fpga_grip) asks of the depth buffer. docs/timing-model.md tells how the numbers come
/// about.
struct ExtractDesign {
    std::uint64_t reads = 1;             ///< per iteration
    std::uint64_t writes = 1;            ///< per iteration: a word again, now with its edge bit
    std::size_t lead = 0;                ///< iterations before the first pixel is judged: the line buffers fill
    std::uint64_t line_buffer_rows = 0;  ///< kept beside the depth buffer
};

/// `window`: side of the window [px], which a stimulus trace decides.
inline ExtractDesign extract_design(AcceleratorConfig const& config, int window) {
    auto const side = static_cast<std::uint64_t>(config.edge_extraction.neighbourhood);
    ExtractDesign design;
    if (config.edge_extraction.neighbour_access == NeighbourAccess::direct) {
        design.reads = side * side;
    } else {
        // The last neighbour lies n/2 rows and n/2 pixels behind.
        design.lead = static_cast<std::size_t>(side / 2) * (static_cast<std::size_t>(window) + 1);
        design.line_buffer_rows = side - 1;
    }
    return design;
}

}  // namespace faster
