#pragma once
#include "dataflow/run/replay/lead_core.hpp"
#include "dataflow/run/replay/scripted_sample.hpp"

namespace dataflow::replay {

/// Cuts what the processes do for a sample into phrases.
class SampleCutter {
  public:
    /// For cores of that shape.
    SampleCutter(timing::CoreTiming const& blueprint, timing::Lead const& lead) : lead_(blueprint, lead) {}

    /// Of canonical() operations. The phrases are those of book(), which has no others, in the order in which they
    /// occur. Without followers there are none: all operations stay before them.
    ScriptedSample cut(SampleOperations operations);
    timing::PhraseBook const& book() const { return book_; }
    LeadCore const& lead() const { return lead_; }

  private:
    timing::OperationLog& log(unsigned member) { return lead_.group.members()[member].process->log(); }
    unsigned index(unsigned member) const { return lead_.group.members()[member].process->index(); }
    void open(unsigned member, ScriptedSample& cut);
    void open_driver(ScriptedSample& cut);
    void close(unsigned member, ScriptedSample& cut);

    LeadCore lead_;
    timing::Phrase phrase_;
    timing::PhraseBook book_;  ///< of the sample at hand
};

/// And back: canonical() operations that take the same time, though they are not always cut as they were. The phrases
/// are those of a book and a group.
SampleOperations joined(ScriptedSample const& cut, timing::PhraseBook const& book, timing::Group const& group);

}  // namespace dataflow::replay
