#pragma once
#include <cstddef>
#include <cstdint>

#include "dataflow/base/counter_random.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::estimation {

/// Who draws from which stream: generation 0 are the first samples, generation k those that iteration k - 1 leaves
/// behind. Substream 0 is its resampling, substream i + 1 its sample i.
inline CounterRandom stream_of_resampling(std::uint64_t seed, std::uint64_t generation) {
    return {seed, generation, 0};
}
inline CounterRandom stream_of_sample(std::uint64_t seed, std::uint64_t generation, std::size_t sample) {
    return {seed, generation, static_cast<std::uint32_t>(sample + 1)};
}

}  // namespace faster::estimation
