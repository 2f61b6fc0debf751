#pragma once
#include <cstddef>
#include <cstdint>

#include "dataflow/core/machine/access_pattern.hpp"
#include "faster/config/accelerator_config.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What inlier_unit.extract (flow fpga_grip) asks of the depth buffer. docs/variants.md tells how the numbers come
/// about.
struct ExtractDesign {
    AccessPattern accesses;              ///< of an iteration: what it reads, and the judged word with its edge bit
    std::uint64_t line_buffer_rows = 0;  ///< kept beside the depth buffer

    /// Iterations before the first pixel is judged: the line buffers fill with half a neighbourhood.
    std::size_t lead(std::size_t row_pixels) const { return line_buffer_rows / 2 * (row_pixels + 1); }
};

ExtractDesign extract_design(AcceleratorConfig const& config);

}  // namespace faster
