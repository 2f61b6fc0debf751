#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "dataflow/tools/recording/core_timeline.hpp"
#include "dataflow/tools/recording/recorded_window.hpp"

namespace dataflow::recording {

/// What the ports of an external memory did in some windows of a run.
struct MemoryTimeline {
    /// A stretch in which a port brings beats, with short breaks.
    struct Span {
        Cycles begin = 0;
        Cycles end = 0;           ///< one past the last cycle
        std::uint64_t bytes = 0;  ///< of reads that were done in it
    };
    struct Port {
        std::vector<Span> busy;
        std::vector<OccupancyPoint> waiting;  ///< requests
    };
    std::vector<Port> ports;
    std::vector<OccupancyPoint> queue;  ///< of the controller
};

/// From cycle `from` to `to`, both included. With at most so many spans and points, or nearly so.
MemoryTimeline make_memory_timeline(RecordedBursts const& memory, Cycles from, Cycles to, std::size_t most);

/// Timelines in the Trace Event Format, which Perfetto and chrome://tracing open. Slices of a track are one inside the
/// other or apart, which Perfetto insists on.
std::string timeline_json(std::vector<CoreTimeline> const& timelines, std::optional<MemoryTimeline> const& memory,
                          double clock_mhz);

}  // namespace dataflow::recording
