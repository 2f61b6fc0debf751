#pragma once
#include "faster/accelerator_config.hpp"

namespace faster::sizing {

/// How many bits a token of a FIFO has in hardware: what the formats of SPEC section 2 need, whatever the model stores
/// it in. docs/formats.md ("Sizes of FIFOs") has the table.
unsigned token_bits(FifoId id, AcceleratorConfig const& config);

}  // namespace faster::sizing
