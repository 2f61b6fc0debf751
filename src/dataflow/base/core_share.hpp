#pragma once
#include <algorithm>
#include <cstddef>

namespace dataflow {

/// The samples that a core does: [first, first + count).
struct CoreShare {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// Which samples a core gets: equal shares in order, the last cores may get fewer, or none.
inline CoreShare share_of(std::size_t core, std::size_t cores, std::size_t samples) {
    std::size_t const each = (samples + cores - 1) / cores;
    std::size_t const first = std::min(samples, core * each);
    return {first, std::min(each, samples - first)};
}

}  // namespace dataflow
