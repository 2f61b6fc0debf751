#pragma once
#include <cstdint>

#include "faster/config/accelerator_config.hpp"

namespace faster::testing {

/// Puts an external memory to a configuration, `axi` and all its keys drawn, from nothing that limits to hardly a byte
/// per cycle; and another clock. Any address, aligned or not. Equal seeds give equal memories with every compiler.
void draw_memory(std::uint64_t seed, AcceleratorConfig& config);

/// Another memory that fetches the same, in another time: all that a recorded run can be retimed with.
void draw_memory_timing(std::uint64_t seed, AcceleratorConfig& config);

}  // namespace faster::testing
