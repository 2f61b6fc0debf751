#pragma once
#include <functional>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/figures/sample_timeline.hpp"
#include "dataflow/run/replay/scripted_run.hpp"

namespace dataflow::explore {

/// The timeline of the i-th of the samples asked for. Called by several threads, once for each i.
using TakeTimeline = std::function<void(std::size_t i, SampleTimeline timeline)>;

/// What the modules did during samples of a recorded run on `machine`: the cores that score them are replayed step by
/// step; where they share a memory, all cores. `samples`: as the run has them on that machine.
void replay_timelines(replay::ScriptedRun const& run, Machine const& machine,
                      std::vector<SampleStatistics> const& samples, TakeTimeline const& take);

/// What the modules did during samples of a run that is replayed once.
void replay_timelines(replay::RecordedRun const& run, Machine const& machine,
                      std::vector<SampleStatistics> const& samples, TakeTimeline const& take);

/// Of one sample.
SampleTimeline replayed_timeline(replay::ScriptedRun const& run, Machine const& machine,
                                 SampleStatistics const& sample);

/// The part from one cycle to another.
SampleTimeline cut(SampleTimeline timeline, Cycles from, Cycles to);

}  // namespace dataflow::explore
