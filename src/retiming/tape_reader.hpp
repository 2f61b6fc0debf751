#pragma once
#include <cstddef>
#include <utility>

#include "io/zstd_frame.hpp"
#include "retiming/known_phrases.hpp"
#include "retiming/operation_tape.hpp"
#include "retiming/scripted_sample.hpp"

namespace faster::retiming {

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

}  // namespace faster::retiming
