#pragma once
#include <memory>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/phrases/phrase_core.hpp"

namespace dataflow::replay {

/// A core with the processes and FIFOs of another, and the depths, latencies and intervals of a machine. Nothing has
/// happened in it yet.
std::unique_ptr<timing::PhraseCore> core_variant(timing::CoreTiming const& blueprint, Machine const& machine);

}  // namespace dataflow::replay
