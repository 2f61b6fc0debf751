#pragma once
#include <cstdint>

namespace dataflow {

/// How many bytes this process could still take without anything else having to make room; as many as can be counted
/// where the host does not say.
std::uint64_t available_memory_bytes();

}  // namespace dataflow
