#pragma once
#include <cstddef>
#include <vector>

#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/script_source.hpp"

namespace dataflow::replay {

/// A recorded run made ready for retiming: its samples are decoded once. Takes 4 bytes per phrase and 8 per operation;
/// samples beyond a quarter of a gigabyte are left to the tape. The run must outlive it. `lead` is that of its machine.
class ScriptedRun : public ScriptSource {
  public:
    /// Reads on so many threads; 0: as many as are worth it.
    ScriptedRun(RecordedRun const& run, timing::Lead const& lead, std::size_t jobs = 0);

    RecordedRun const& run() const { return *run_; }
    timing::Lead const& lead() const { return lead_; }
    timing::PhraseBook const& book() const override { return book_; }
    std::size_t size() const override { return samples_.size(); }
    ScriptedSample const& operator[](std::size_t sample) const override { return samples_[sample]; }

  private:
    RecordedRun const* run_;
    timing::Lead lead_;
    timing::PhraseBook book_;
    std::vector<ScriptedSample> samples_;
};

}  // namespace dataflow::replay
