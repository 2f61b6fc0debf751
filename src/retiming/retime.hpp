#pragma once
#include "config/accelerator_config.hpp"
#include "retiming/recorded_run.hpp"

namespace faster::retiming {

struct Retimed {
    bool deadlocked = false;
    Cycles total_cycles = 0;  ///< as of a run; unless it deadlocked
};

/// How long a recorded run takes with other timing keys: equal to running it. `config` must have as many cores as the
/// run, and differ from its configuration in timing_keys() only.
Retimed retime(RecordedRun const& run, AcceleratorConfig const& config);

}  // namespace faster::retiming
