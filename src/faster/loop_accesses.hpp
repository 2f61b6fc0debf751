#pragma once
#include <vector>

#include "faster/accelerator_config.hpp"
#include "kernel/machine/access_pattern.hpp"

namespace faster {

/// What one iteration of a loop asks of one memory.
struct MemoryAccess {
    BramId bram;
    AccessPattern pattern;
};

/// SPEC section 3, "BRAM accesses per iteration": the worst branch, whatever the data. In the order of BramId; only
/// memories that the loop touches.
std::vector<MemoryAccess> loop_accesses(LoopId id, AcceleratorConfig const& config);

}  // namespace faster
