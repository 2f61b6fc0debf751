#pragma once
#include <cstdint>

namespace dataflow {

/// How many bytes this process could still take without anything else having to make room; as many as can be counted
/// where the host does not say.
std::uint64_t available_memory_bytes();

/// How many bytes of addresses this process has, whether they are backed by memory or not: what RLIMIT_AS limits.
std::uint64_t address_bytes();

}  // namespace dataflow
