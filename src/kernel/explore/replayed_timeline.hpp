#pragma once
#include "kernel/figures/run_statistics.hpp"
#include "kernel/figures/sample_timeline.hpp"
#include "kernel/replay/recorded_run.hpp"

namespace faster::explore {

/// What the modules did during one sample of a recorded run on `machine`, whose memory is ideal: the core that scores
/// it is replayed step by step. `sample`: as the retimed run has it.
SampleTimeline replayed_timeline(replay::RecordedRun const& run, Machine const& machine,
                                 SampleStatistics const& sample);

/// The part from one cycle to another.
SampleTimeline cut(SampleTimeline timeline, Cycles from, Cycles to);

}  // namespace faster::explore
