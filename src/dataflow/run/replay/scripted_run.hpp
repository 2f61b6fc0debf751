#pragma once
#include <cstddef>
#include <memory>

#include "dataflow/run/replay/formed_samples.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/script_source.hpp"

namespace dataflow::replay {

/// A recorded run made ready for retiming: its samples, as they were told, are decoded once. Takes 4 bytes per phrase
/// and 8 per operation, and as much for each form that cores have; samples beyond a quarter of a gigabyte are left to
/// the tape. The run must outlive it.
class ScriptedRun : public ScriptSource {
  public:
    /// For how many retimings: to put samples into another form takes as long as some of them.
    enum class Uses { few, many };

    /// Reads on so many threads; 0: as many as are worth it.
    explicit ScriptedRun(RecordedRun const& run, Uses uses = Uses::many, std::size_t jobs = 0);

    RecordedRun const& run() const { return *run_; }
    timing::Lead const& lead() const { return run_->lead; }
    std::size_t jobs() const { return jobs_; }
    /// Those that a core of a machine, which follows the lead, goes through most quickly. This must outlive them.
    std::shared_ptr<ScriptSource const> samples_for(timing::PhraseCore& core, Machine const& machine) const;

  private:
    RecordedRun const* run_;
    std::size_t jobs_;
    std::unique_ptr<KnownForms> forms_;  ///< null: none but as they were told
};

}  // namespace dataflow::replay
