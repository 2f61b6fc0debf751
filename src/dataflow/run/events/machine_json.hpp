#pragma once
#include "dataflow/base/json.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/replay/recorded_run.hpp"

namespace dataflow::events {

/// What a run had to do with its external memory: numbers in the order of the structures' fields.
Json memory_json(replay::RecordedMemory const& memory);

/// And back, for a run of so many samples on `machine`; nothing if its memory is ideal. Throws Json::exception or
/// std::invalid_argument for what cannot be of such a run.
void read_memory(Json const& index, Machine const& machine, std::size_t samples, replay::RecordedRun& run);

/// A core's processes with their ports and loops, and where those stand in the source.
Json machine_json(timing::CoreTiming const& blueprint);

/// And back: blueprint and source files of a run on `machine`. Throws Json::exception or std::invalid_argument for what
/// says anything else than that machine has.
void read_machine(Json const& json, Machine const& machine, replay::RecordedRun& run);

}  // namespace dataflow::events
