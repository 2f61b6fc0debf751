#pragma once
#include <string>

#include "dataflow/core/machine/machine_settings.hpp"
#include "dataflow/core/machine/module_description.hpp"

namespace dataflow {

/// A core whose modules hand calls to each other, which are samples (docs/timing-model.md#calls). What is handed over
/// are tokens of FIFOs without latencies, so that the kernel's rules are enough:
///   ping-pong buffer   NAME: taken when its writer's call begins, free when its reader's call ends; NAME_filled: from
///                      when its writer's call ends to when its reader's begins. Besides, a memory NAME
///   calls in turn      MODULE_begins: the first module lets the others begin; MODULE_ends: they keep it from beginning
///                      again before they are done
CoreDescription with_calls(CoreDescription core, MachineSettings const& settings);

/// The FIFO that passes on what a ping-pong buffer holds.
inline std::string filled_fifo(std::string const& buffer) { return buffer + "_filled"; }

}  // namespace dataflow
