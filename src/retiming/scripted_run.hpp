#pragma once
#include <vector>

#include "config/parts.hpp"
#include "retiming/recorded_run.hpp"
#include "timing/phrase_book.hpp"

namespace faster::retiming {

/// A sample's operations with the long middle as phrases of the lead group (timing::Script).
struct ScriptedSample {
    SampleOperations before;  ///< by process
    std::vector<timing::PhraseBook::Number> phrases;
    SampleOperations after;
    timing::Script script;  ///< of the phrases; without pointers
};

/// A recorded run made ready for many retimings: its samples are decoded, and cut into phrases, once. Takes 4 bytes per
/// phrase; samples beyond a quarter of a gigabyte are left to the tape. The run must outlive it. `flow` is that of its
/// configuration.
class ScriptedRun {
  public:
    ScriptedRun(RecordedRun const& run, Parts const& parts);

    RecordedRun const& run() const { return *run_; }
    timing::PhraseBook const& book() const { return book_; }
    std::size_t size() const { return samples_.size(); }
    ScriptedSample const& operator[](std::size_t sample) const { return samples_[sample]; }

  private:
    RecordedRun const* run_;
    timing::PhraseBook book_;
    std::vector<ScriptedSample> samples_;
};

}  // namespace faster::retiming
