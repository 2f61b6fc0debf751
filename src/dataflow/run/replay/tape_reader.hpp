#pragma once
#include <cstddef>
#include <utility>

#include "dataflow/base/files/zstd_frame.hpp"
#include "dataflow/run/replay/known_phrases.hpp"
#include "dataflow/run/replay/operation_tape.hpp"
#include "dataflow/run/replay/scripted_sample.hpp"

namespace dataflow::replay {

/// Reads samples from a tape, which must outlive it, in any order. Several threads have one each.
class TapeReader {
  public:
    TapeReader(OperationTape const& tape, LeadCore lead) : tape_(tape), known_(std::move(lead)) {}

    /// A sample, as processes of known().lead() can do it, with phrases of known().book(). InputError if its block is
    /// damaged.
    ScriptedSample read(std::size_t sample);
    KnownPhrases const& known() const { return known_; }
    timing::PhraseBook take_book() && { return std::move(known_).take_book(); }

  private:
    OperationTape const& tape_;
    KnownPhrases known_;
    OperationTape::Bytes frame_;
    io::ZstdReader zstd_;
};

}  // namespace dataflow::replay
