#pragma once
#include <string>
#include <vector>

#include "dataflow/commands/recording_options.hpp"
#include "dataflow/commands/run_extras.hpp"
#include "dataflow/commands/subcommand.hpp"

namespace dataflow {

/// `run`.
struct RunRequest {
    std::string config;
    std::vector<std::string> overrides;  ///< KEY=VALUE
    std::string out;                     ///< folder; empty: print only
    std::string report;                  ///< HTML file; empty: none
    std::string report_samples;          ///< whose timelines it shows besides, e.g. 5-7 or all; empty: none
    std::string events;                  ///< event file; empty: none
    bool critical_path = false;          ///< trace it
    bool sensitivities = false;          ///< work them out
    bool force = false;                  ///< however long it takes, whatever memory there is
    bool hazards = false;                ///< look for them
    std::size_t jobs = 0;                ///< threads; 0: as many as the host has cores
    RecordingRequest recording;
};

/// Returns the exit code; throws InputError on bad input.
int run(RunRequest const& request, RunExtras& extras);

Subcommand run_command(MakeRunExtras const& extras = [] { return std::make_unique<RunExtras>(); });

}  // namespace dataflow
