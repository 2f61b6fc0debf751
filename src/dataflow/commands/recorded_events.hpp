#pragma once
#include "kernel/base/files/output_file.hpp"
#include "kernel/config/load_config.hpp"
#include "kernel/figures/run_statistics.hpp"
#include "kernel/replay/recorded_run.hpp"

namespace faster {

/// The event file of a run that did not deadlock. Without what was asked for besides: an event file says what the run
/// did and how long it took. `function`: see EventFile.
void write_events(io::OutputFile const& file, LoadedConfig const& loaded, replay::RecordedRun const& recorded,
                  RunStatistics run, std::string const& function = "");

}  // namespace faster
