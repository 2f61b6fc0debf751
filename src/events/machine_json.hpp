#pragma once
#include <nlohmann/json.hpp>

#include "config/parts.hpp"
#include "retiming/recorded_run.hpp"

namespace faster::events {

using Json = nlohmann::ordered_json;

/// A core's processes with their ports and loops, and where those stand in the source.
Json machine_json(timing::CoreTiming const& blueprint);

/// And back: blueprint, with these parts, and source files of a run. Throws Json::exception or std::invalid_argument
/// for what is no machine of this version.
void read_machine(Json const& machine, Parts const& parts, retiming::RecordedRun& run);

}  // namespace faster::events
