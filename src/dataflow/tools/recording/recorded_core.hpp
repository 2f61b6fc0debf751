#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "dataflow/base/token_field.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/tools/recording/event_spool.hpp"
#include "dataflow/tools/recording/memory_activity.hpp"

namespace dataflow::recording {

/// What was recorded of one core.
struct RecordedCore {
    std::size_t core = 0;
    Machine const* machine = nullptr;
    Cycles from = 0;  ///< first and last cycle
    Cycles to = 0;
    std::vector<timing::FifoShape> fifos;                ///< by FIFO
    std::vector<std::vector<TokenField>> token_layouts;  ///< by FIFO
    /// Makes a new one; may make none, or be empty.
    std::function<std::unique_ptr<MemoryActivity>()> memory_activity;
    Spools* spools = nullptr;  ///< its events
};

}  // namespace dataflow::recording
