#pragma once
#include <string>
#include <vector>

#include "kernel/recording/core_timeline.hpp"

namespace faster::recording {

/// The Trace Event Format of Chrome and Perfetto: a process per core, a track per module with its loops and, inside
/// them, its stalls, a track of samples, a counter per FIFO. Times are microseconds at the clock.
std::string timeline_json(std::vector<CoreTimeline> const& timelines, double clock_mhz);

}  // namespace faster::recording
