#pragma once
#include "dataflow/base/files/output_file.hpp"
#include "dataflow/run/config/load_config.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/recorded_run.hpp"

namespace dataflow {

/// The event file of a run that did not deadlock. Without what was asked for besides: an event file says what the run
/// did and how long it took. `function`: see EventFile.
void write_events(io::OutputFile const& file, LoadedConfig const& loaded, replay::RecordedRun const& recorded,
                  RunStatistics run, std::string const& function = "");

}  // namespace dataflow
