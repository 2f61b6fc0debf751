#pragma once
#include <memory>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/phrases/phrase_core.hpp"

namespace dataflow::replay {

/// A core of a machine with the ends of the external memory and the places in the source that a recorded one has.
/// Nothing has happened in it yet.
std::unique_ptr<timing::PhraseCore> core_variant(timing::CoreTiming const& blueprint, Machine const& machine);

}  // namespace dataflow::replay
