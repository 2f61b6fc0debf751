#pragma once
#include <cstdint>

#include "faster/config/accelerator_config.hpp"
#include "faster/data/stimulus.hpp"

namespace faster::testing {

/// A random workload on a random machine with a random memory. Every fourth machine may deadlock, every third has
/// variants drawn, every eleventh is of flow fpga_grip.
struct MemoryTrial {
    Stimulus stimulus;
    AcceleratorConfig config;
};
MemoryTrial memory_trial(std::uint64_t seed);
/// From this seed on windows have more than a thousand pixels.
constexpr std::uint64_t first_with_large_windows = 50000;

/// What a retiming of it may change, changed at random.
AcceleratorConfig other_timing(std::uint64_t seed, AcceleratorConfig config);

/// Checks that both engines agree with the twin, seeds first .. first + count - 1. Returns how many deadlocked.
int check_memory_seeds(std::uint64_t first, std::uint64_t count);

/// Records each trial, and retimes it with another memory, other cores and FIFOs: that is as it runs there, and as the
/// twin does, and with an ideal memory as well. Trials that deadlock are not recorded. Returns how many were.
int check_memory_retimings(std::uint64_t first, std::uint64_t count);

}  // namespace faster::testing
