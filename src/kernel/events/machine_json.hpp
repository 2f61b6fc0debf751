#pragma once
#include "kernel/base/json.hpp"
#include "kernel/machine/machine.hpp"
#include "kernel/replay/recorded_run.hpp"

namespace faster::events {

/// A core's processes with their ports and loops, and where those stand in the source.
Json machine_json(timing::CoreTiming const& blueprint);

/// And back: blueprint and source files of a run on `machine`. Throws Json::exception or std::invalid_argument for what
/// says anything else than that machine has.
void read_machine(Json const& json, Machine const& machine, replay::RecordedRun& run);

}  // namespace faster::events
