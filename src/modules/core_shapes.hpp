#pragma once
#include "faster/parts.hpp"
#include "kernel/timing/lead.hpp"
#include "kernel/timing/process_timing.hpp"

namespace faster {

/// A FIFO's kind with `automatic` decided: shift register up to depth 2, memory above.
FifoKind resolved_kind(FifoConfig const& config);

/// A FIFO of the configuration as the timing sees it (SPEC section 3, FIFO).
timing::FifoShape fifo_shape(FifoId id, AcceleratorConfig const& config);

/// The initiation interval of a loop, from its pragma, its recurrence and the block RAM accesses of SPEC section 3.
timing::InitiationInterval initiation_interval(LoopId id, AcceleratorConfig const& config);

/// Pipeline stages of a loop, those of the square root and the divider included (inlier_unit.extract).
Cycles loop_depth(LoopId id, AcceleratorConfig const& config);

/// A loop that only reads FIFOs, or none.
timing::LoopShape loop_shape(LoopId id, AcceleratorConfig const& config);

/// The rasterizer sets the pace while it draws.
timing::Lead rasterizer_and_followers(Parts const& parts);

}  // namespace faster
