#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "tb/recording_options.hpp"

namespace faster {

/// `faster-sim run`.
struct RunRequest {
    std::string config;
    std::vector<std::string> overrides;  ///< KEY=VALUE
    std::string trace;                   ///< folder; empty: as configured
    std::string out;                     ///< folder; empty: print only
    std::string report;                  ///< HTML file; empty: none
    std::string events;                  ///< event file; empty: none
    bool critical_path = false;          ///< trace it
    bool sensitivities = false;          ///< work them out
    std::int64_t images = 0;             ///< samples to write pictures of
    RecordingRequest recording;
};

/// `faster-sim record`.
struct RecordRequest {
    std::string config;
    std::vector<std::string> overrides;
    std::string out;
};

/// Both return the exit code, and throw InputError on bad input.
int run(RunRequest const& request);
int record(RecordRequest const& request);

}  // namespace faster
