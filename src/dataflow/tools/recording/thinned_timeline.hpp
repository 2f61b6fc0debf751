#pragma once
#include <cstddef>

#include "dataflow/tools/recording/core_timeline.hpp"

namespace dataflow::recording {

/// The timeline with at most so many spans and points, half of it each: seen from as far away as it takes. Then spans
/// of the same loop, or of stalls on the same FIFO, that follow one another closely are one, short ones are left out,
/// and an occupancy is the largest in a longer stretch.
CoreTimeline thinned(CoreTimeline timeline, std::size_t most);

}  // namespace dataflow::recording
