#pragma once
#include <cstddef>
#include <stdexcept>

#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/replay/scripted_sample.hpp"

namespace dataflow::replay {

/// Samples, by number, as phrases of one book.
class ScriptSource {
  public:
    virtual ~ScriptSource() = default;
    virtual timing::PhraseBook const& book() const = 0;
    /// Samples from this one on are not there.
    virtual std::size_t size() const = 0;
    virtual ScriptedSample const& operator[](std::size_t sample) const = 0;
    /// That samples have; see PhraseCore. Empty: as they were told.
    virtual timing::PhraseCore::Form const& form() const = 0;

  protected:
    ScriptSource() = default;
    ScriptSource(ScriptSource const&) = default;
    ScriptSource& operator=(ScriptSource const&) = default;
    ScriptSource(ScriptSource&&) = default;
    ScriptSource& operator=(ScriptSource&&) = default;
};

/// Has no samples: all are plain.
class NoScripts : public ScriptSource {
  public:
    timing::PhraseBook const& book() const override { return book_; }
    std::size_t size() const override { return 0; }
    ScriptedSample const& operator[](std::size_t /*sample*/) const override {
        throw std::logic_error("there are no scripts");
    }
    timing::PhraseCore::Form const& form() const override { return form_; }

  private:
    timing::PhraseBook book_;
    timing::PhraseCore::Form form_;
};

}  // namespace dataflow::replay
