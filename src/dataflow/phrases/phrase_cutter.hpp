#pragma once
#include <memory>
#include <vector>

#include "dataflow/phrases/group.hpp"
#include "dataflow/phrases/phrase_book.hpp"

namespace dataflow::timing {

/// Cuts phrases of a book into pieces. Lines of pixels differ in length and in the silence behind them, so that there
/// are many; of the single pixels and silences in them there are few.
class PhraseCutter {
  public:
    /// More than so many would take more room than they save work.
    static constexpr std::size_t most_pieces = 64;

    /// For the groups of cores of that shape.
    PhraseCutter(CoreTiming const& core, Lead const& lead);
    ~PhraseCutter();

    /// Enters the pieces in the book. A phrase that cannot be cut, or is too long, has none.
    void cut(PhraseBook& book, PhraseBook::Number number);
    /// All that are in the book now, from a number on.
    void cut_from(PhraseBook& book, std::size_t first);

  private:
    OperationLog& log(unsigned member) const { return group_.members()[member].process->log(); }
    bool write(PhraseBook const& book, PhraseBook::Number number);
    bool goes_on_answering(unsigned member) const;
    bool is_all_read() const;

    std::unique_ptr<CoreTiming> core_;  // the logs are what is needed of it
    Group group_;
    Phrase phrase_;
    std::vector<Ports::Number> log_ends_;  ///< by member: ports of the step that it goes on with
};

}  // namespace dataflow::timing
