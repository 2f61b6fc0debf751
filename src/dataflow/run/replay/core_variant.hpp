#pragma once
#include <memory>

#include "dataflow/base/input_error.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/phrases/phrase_core.hpp"

namespace dataflow::replay {

/// What was recorded does not say what a run would do.
class NotRetimable : public InputError {
  public:
    using InputError::InputError;
};

/// A core of a machine with the ends of the external memory and the places in the source that a recorded one has.
/// Nothing has happened in it yet. Throws NotRetimable where a module reads too late for what it does next.
std::unique_ptr<timing::PhraseCore> core_variant(timing::CoreTiming const& blueprint, Machine const& machine);

}  // namespace dataflow::replay
