#pragma once
#include <cstddef>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/replay/script_source.hpp"

namespace dataflow::replay {

class ScriptedRun;

/// Samples of a run in a form in which cores go through them more quickly; see PhraseCore::form().
class FormedSamples : public ScriptSource {
  public:
    /// In `form`, that of cores of a machine. Null if one of the samples cannot be told so: who follows a script is
    /// told the others in its form, too.
    static std::shared_ptr<FormedSamples const> of(ScriptedRun const& run, timing::PhraseCore::Form const& form,
                                                   Machine const& machine);

  private:
    explicit FormedSamples(timing::PhraseCore::Form form) { form_ = std::move(form); }
};

/// The forms that were asked for last.
class KnownForms {
  public:
    /// Waits where another thread is putting the samples into this form.
    std::shared_ptr<FormedSamples const> find(ScriptedRun const& run, timing::PhraseCore::Form const& form,
                                              Machine const& machine);

  private:
    static constexpr std::size_t most = 6;
    struct Entry {
        timing::PhraseCore::Form form;
        std::once_flag formed;
        std::shared_ptr<FormedSamples const> samples;
    };
    std::shared_ptr<Entry> entry_of(timing::PhraseCore::Form const& form);

    std::mutex mutex_;
    std::vector<std::shared_ptr<Entry>> entries_;  ///< the last that was asked for at the end
};

}  // namespace dataflow::replay
