#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "dataflow/base/core_share.hpp"
#include "dataflow/base/cycles.hpp"
#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/script_source.hpp"

namespace dataflow::replay {

/// Lets one core do the operations of its samples, one sample after the other.
class Replay {
  public:
    /// Reads a sample as operations.
    using Plain = std::function<SampleOperations(std::size_t sample)>;

    /// Samples that the source does not have, and all of a core that is stuck, are plain. The core follows `lead`.
    /// Everything must outlive it but `plain`, `lead` and `leaves`.
    Replay(ScriptSource const& source, Plain plain, CoreShare share, timing::PhraseCore& core, timing::Lead const& lead,
           Leaves leaves = nullptr);

    /// As far as a walk of the core, or a walk further; false: all is done, or left, or nothing can be done any more.
    bool go_on();
    timing::PhraseCore& core() { return core_; }

    /// Some process will never do what was asked of it.
    bool is_stuck() const;

  private:
    static constexpr std::size_t usual_backlog = std::size_t{1} << 18;  // operations: a few samples' worth

    bool begin_script(std::size_t sample);
    void end_sample(std::size_t sample);
    void feed_plain(std::size_t sample);
    void take_up(ScriptedSample const& scripted, std::size_t sample);
    void supply(std::size_t end);
    std::size_t backlog();
    Cycles all_times() const;
    void find_stuck();
    std::vector<std::optional<std::size_t>> awaited_processes();

    ScriptSource const& source_;
    Plain plain_;
    CoreShare share_;
    timing::PhraseCore& core_;
    Leaves leaves_;
    bool has_followers_;          ///< without, scripts have no phrases
    std::size_t supplier_;        ///< the process that is ahead of the driver; none: the number of no process
    std::vector<bool> is_stuck_;  ///< by process
    Cycles times_before_ = 0;     ///< the sample at hand
    bool is_over_ = false;        ///< nobody will do anything any more
    std::size_t supplied_ = 0;    ///< samples that the supplier has been asked for
    std::size_t fed_ = 0;         ///< samples done
    bool is_scripted_ = false;    ///< the sample at hand
    bool is_walking_ = false;
    timing::Script script_;
};

}  // namespace dataflow::replay
