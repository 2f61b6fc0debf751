#pragma once

#include "faster/parts.hpp"
#include "kernel/base/json.hpp"
#include "kernel/replay/recorded_run.hpp"

namespace faster::events {

/// A core's processes with their ports and loops, and where those stand in the source.
Json machine_json(timing::CoreTiming const& blueprint);

/// And back: blueprint, with these parts, and source files of a run. Throws Json::exception or std::invalid_argument
/// for what is no machine of this version.
void read_machine(Json const& machine, Parts const& parts, retiming::RecordedRun& run);

}  // namespace faster::events
