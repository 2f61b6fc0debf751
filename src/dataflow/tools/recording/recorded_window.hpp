#pragma once
#include <vector>

#include "dataflow/tools/recording/memory_recorder.hpp"
#include "dataflow/tools/recording/recorded_core.hpp"

namespace dataflow::recording {

/// What was recorded of a window of a run. The events of its cores can be gone through once.
struct RecordedWindow {
    std::vector<RecordedCore> cores;
    RecordedBursts const* memory = nullptr;  ///< that the cores share; null: none

    /// First and last cycle in which something was recorded; 0 if there are no cores.
    Cycles from() const;
    Cycles to() const;
};

}  // namespace dataflow::recording
