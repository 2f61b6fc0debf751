#pragma once
#include <cstdint>

namespace dataflow::processes {

/// For a child process that runs code which may go wrong in any way: it may take so many bytes of memory more than its
/// parent had (beyond them allocations fail), says nothing, and leaves no image of its memory when it crashes.
void confine_process(std::uint64_t more_memory_bytes);

}  // namespace dataflow::processes
