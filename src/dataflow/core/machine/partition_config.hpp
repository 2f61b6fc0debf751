#pragma once
#include <cstdint>

namespace dataflow {

/// How a memory is split into banks, which work side by side: `array_partition` of HLS.
enum class PartitionType {
    none,
    cyclic,  ///< neighbours lie in different banks
    block,   ///< neighbours lie in one bank, as long as it lasts
};

/// Partition of one block RAM; keys `accelerator.brams.NAME.partition.*`.
struct PartitionConfig {
    PartitionType type = PartitionType::none;
    std::uint64_t factor = 1;     ///< banks along each dimension that is split, >= 1
    std::uint64_t dimension = 0;  ///< what is split: 1 rows, 2 columns, 0 both
};

}  // namespace dataflow
