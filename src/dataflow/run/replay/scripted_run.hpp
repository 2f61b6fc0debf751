#pragma once
#include <cstddef>
#include <vector>

#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/script_source.hpp"

namespace dataflow::replay {

/// A recorded run made ready for retiming: its samples are decoded once, and put into the form in which a core of the
/// recorded machine goes through them most quickly. Takes 4 bytes per phrase and 8 per operation; samples beyond a
/// quarter of a gigabyte are left to the tape. The run must outlive it. `lead` is that of its machine.
class ScriptedRun : public ScriptSource {
  public:
    /// For how many retimings: to put samples into another form takes as long as some of them.
    enum class Uses { few, many };

    /// Reads on so many threads; 0: as many as are worth it.
    ScriptedRun(RecordedRun const& run, timing::Lead const& lead, Uses uses = Uses::many, std::size_t jobs = 0);

    RecordedRun const& run() const { return *run_; }
    timing::Lead const& lead() const { return lead_; }
    timing::PhraseBook const& book() const override { return book_; }
    std::size_t size() const override { return samples_.size(); }
    ScriptedSample const& operator[](std::size_t sample) const override { return samples_[sample]; }
    timing::PhraseCore::Form const& form() const override { return form_; }

  private:
    RecordedRun const* run_;
    timing::Lead lead_;
    timing::PhraseCore::Form form_;
    timing::PhraseBook book_;
    std::vector<ScriptedSample> samples_;
};

}  // namespace dataflow::replay
