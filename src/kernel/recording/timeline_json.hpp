#pragma once
#include <optional>
#include <string>
#include <vector>

#include "kernel/recording/core_timeline.hpp"
#include "kernel/recording/memory_timeline.hpp"

namespace faster::recording {

/// Timelines in the Trace Event Format, which Perfetto and chrome://tracing open. Slices of a track are one inside the
/// other or apart, which Perfetto insists on.
std::string timeline_json(std::vector<CoreTimeline> const& timelines, std::optional<MemoryTimeline> const& memory,
                          double clock_mhz);

}  // namespace faster::recording
