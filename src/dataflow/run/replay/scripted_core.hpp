#pragma once
#include <cstddef>

#include "dataflow/base/core_share.hpp"
#include "dataflow/phrases/phrase_core.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/script_source.hpp"

namespace dataflow::replay {

/// A core behind an external memory that follows the scripts of its samples. All that is in no script has been logged
/// from the start, so whenever it stops it has got as far as it can with what the memory has brought so far.
class ScriptedCore {
  public:
    /// All of the samples must be scripted. The core follows the lead, and all but that must outlive this.
    ScriptedCore(ScriptSource const& source, timing::Lead const& lead, CoreShare share, timing::PhraseCore& core,
                 Leaves leaves);

    /// As far as it gets, once the memory has brought something for some processes, a bit each.
    void go_on(timing::ProcessMask woken);
    /// It has stopped, and a process could go on by itself with what comes behind the script at hand: it may have
    /// stopped too early.
    bool has_more_to_say() const { return has_more_to_say_; }

  private:
    bool follow();
    void take_up_next();
    void end_sample();
    bool still_waits(timing::ProcessMask woken);
    bool awaits_driver() const;
    void note_who_is_done();
    bool has_more(std::size_t process) const;
    ScriptedSample const& sample() const { return source_[share_.first + fed_]; }

    ScriptSource const& source_;
    CoreShare share_;
    timing::PhraseCore& core_;
    timing::Group group_;
    Leaves leaves_;
    timing::Script script_;
    std::size_t fed_ = 0;  ///< samples done
    bool is_following_ = false;
    bool is_left_ = false;
    bool has_more_to_say_ = false;
};

}  // namespace dataflow::replay
