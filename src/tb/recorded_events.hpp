#pragma once
#include "config/load_config.hpp"
#include "io/output_file.hpp"
#include "retiming/recorded_run.hpp"
#include "stats/run_statistics.hpp"

namespace faster {

/// The event file of a run that did not deadlock. Without what was asked for besides: an event file says what the run
/// did and how long it took.
void write_events(io::OutputFile const& file, LoadedConfig const& loaded, retiming::RecordedRun const& recorded,
                  RunStatistics run);

}  // namespace faster
