#pragma once
#include <string>
#include <string_view>

#include "dataflow/run/replay/known_phrases.hpp"
#include "dataflow/run/replay/scripted_sample.hpp"

namespace dataflow::replay {

/// A sample as bytes (docs/formats.md, "Event files"): operations by process as a table of the shapes that occur, then
/// columns, which compress better than whole operations do; and the phrases, which must be those of `book`.
std::string encode(ScriptedSample const& sample, timing::PhraseBook const& book);

/// And back, for the processes of known.lead(), with phrases of known.book(). False if the bytes say what they cannot
/// do.
bool decode(std::string_view bytes, KnownPhrases& known, ScriptedSample& sample);

}  // namespace dataflow::replay
