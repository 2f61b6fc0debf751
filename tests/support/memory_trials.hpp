#pragma once
#include <cstdint>

namespace faster::testing {

/// Runs random workloads on random machines with random memories, seeds first .. first + count - 1, and checks that
/// both engines agree with the twin. Returns how many deadlocked. Every fourth machine may deadlock, every third has
/// variants drawn, every eleventh is of flow fpga_grip.
int check_memory_seeds(std::uint64_t first, std::uint64_t count);

}  // namespace faster::testing
