#pragma once
#include "faster/accelerator_config.hpp"

namespace faster {

/// What `scan: spans` adds to a triangle's setup: 18 quotient bits, a bit per cycle, of the two divisions per edge
/// (where it crosses the first row, how far that moves from row to row), all six side by side.
constexpr Cycles span_division_cycles = 18;

/// Cycles from a triangle's last vertex to its area.
inline Cycles setup_cycles(AcceleratorConfig const& config) {
    return config.setup_depth + (config.rasterizer.scan == ScanPolicy::spans ? span_division_cycles : 0);
}

}  // namespace faster
