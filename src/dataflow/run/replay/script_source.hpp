#pragma once
#include <cstddef>
#include <vector>

#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/replay/scripted_sample.hpp"

namespace dataflow::replay {

/// Samples, by number, as phrases of one book. Without a derived class that puts some in there are none: all are plain.
class ScriptSource {
  public:
    ScriptSource() = default;
    virtual ~ScriptSource() = default;
    virtual timing::PhraseBook const& book() const { return book_; }
    /// Samples from this one on are not there.
    virtual std::size_t size() const { return samples_.size(); }
    virtual ScriptedSample const& operator[](std::size_t sample) const { return samples_[sample]; }
    /// That samples have; see PhraseCore. Empty: as they were told.
    virtual timing::PhraseCore::Form const& form() const { return form_; }

  protected:
    ScriptSource(ScriptSource const&) = default;
    ScriptSource& operator=(ScriptSource const&) = default;
    ScriptSource(ScriptSource&&) = default;
    ScriptSource& operator=(ScriptSource&&) = default;

    timing::PhraseCore::Form form_;
    timing::PhraseBook book_;
    std::vector<ScriptedSample> samples_;
};

}  // namespace dataflow::replay
