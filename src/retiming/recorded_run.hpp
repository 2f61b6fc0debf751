#pragma once
#include <memory>
#include <vector>

#include "retiming/operation_tape.hpp"
#include "timing/core_timing.hpp"

namespace faster::retiming {

/// All that a run did, without the time it took: the function of the dataflow does not depend on its timing, as it
/// reads and writes its FIFOs blocking, and only so.
struct RecordedRun {
    std::unique_ptr<timing::CoreTiming> blueprint;  ///< FIFOs and processes that all cores have, nothing done yet
    std::vector<OperationTape> cores;
};

}  // namespace faster::retiming
