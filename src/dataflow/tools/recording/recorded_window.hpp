#pragma once
#include <algorithm>
#include <vector>

#include "dataflow/tools/recording/memory_recorder.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"

namespace dataflow::recording {

/// What was recorded of a window of a run. The events of its cores can be gone through once.
struct RecordedWindow {
    std::vector<RecordedCore> cores;
    RecordedBursts const* memory = nullptr;  ///< that the cores share; null: none

    /// First and last cycle in which something was recorded; 0 if there are no cores.
    Cycles from() const {
        Cycles from = cores.empty() ? 0 : cores.front().from;
        for (RecordedCore const& core : cores)
            from = std::min(from, core.from);
        return from;
    }
    Cycles to() const {
        Cycles to = 0;
        for (RecordedCore const& core : cores)
            to = std::max(to, core.to);
        return to;
    }
};

}  // namespace dataflow::recording
