#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <vector>

#include "dataflow/core/machine/core_share.hpp"
#include "dataflow/phrases/phrase_cutter.hpp"
#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/run/replay/lead_core.hpp"
#include "dataflow/run/replay/recorded_run.hpp"
#include "dataflow/run/replay/replay.hpp"
#include "dataflow/run/replay/script_source.hpp"

namespace dataflow::replay {

/// Works out the time of a run while it is recorded, from the phrases that are recorded, sample by sample. What has
/// been timed is forgotten, but for the phrases; when there are too many of those, as in runs that never say the same,
/// samples are timed as operations: memory does not grow with the run.
class LiveRetiming {
  public:
    /// For cores like `blueprint` but with the timing of a machine, which must outlive this, and their shares of the
    /// samples.
    LiveRetiming(timing::CoreTiming const& blueprint, Machine const& machine, std::vector<CoreShare> const& shares);
    ~LiveRetiming();
    LiveRetiming(LiveRetiming const&) = delete;
    LiveRetiming& operator=(LiveRetiming const&) = delete;

    /// The next sample of a core, as phrases of a book.
    void put(std::size_t sample, ScriptedSample scripted, timing::PhraseBook const& book);
    /// The figures of the run; `counters` by sample. None if it got stuck: who wants to know why has to time the
    /// operations.
    std::optional<RunStatistics> finish(std::vector<Counters> const& counters);

  private:
    /// The samples of one core that it has not done yet.
    class Window;
    struct Core;

    static constexpr std::size_t most_bytes_of_phrases = std::size_t{1} << 24;

    Core& core_of(std::size_t sample);

    Machine const& machine_;
    LeadCore lead_;
    timing::PhraseBook book_;
    timing::PhraseCutter cutter_;
    std::vector<std::unique_ptr<Core>> cores_;
    bool is_stuck_ = false;  ///< some core: what the others do does not matter any more
};

}  // namespace dataflow::replay
