#pragma once
#include <cstddef>
#include <vector>

#include "dataflow/base/uninitialized.hpp"
#include "dataflow/phrases/phrase_book.hpp"
#include "dataflow/run/replay/sample_operations.hpp"

namespace dataflow::replay {

/// A sample's operations with the long middle, where the lead group is at work, as phrases of it. Of its supplier,
/// which is ahead by as much as a FIFO holds, all operations are in `before`.
struct ScriptedSample {
    static constexpr std::size_t most_phrases = std::size_t{1} << 24;  ///< all others stay operations

    SampleOperations before;  ///< by process
    using Phrases = std::vector<timing::PhraseBook::Number, Uninitialized<timing::PhraseBook::Number>>;

    Phrases phrases;
    SampleOperations after;  ///< by process
    timing::Script script;   ///< of the phrases; without pointers

    /// For a core to follow; the book is that of the phrases.
    timing::Script script_in(timing::PhraseBook const& book) const {
        timing::Script whole = script;
        whole.book = &book;
        whole.next = phrases.data();
        whole.end = whole.next + phrases.size();
        return whole;
    }
    /// Tells the processes what they do behind the phrases.
    void tell_rest(timing::CoreTiming& core) const {
        for (std::size_t i = 0; i < after.size(); ++i)
            for (timing::Operation const& operation : after[i])
                core.process(i).log().append(operation);
    }

    /// To the numbers that its phrases have in another book.
    void renumber(std::vector<timing::PhraseBook::Number> const& numbers) {
        for (timing::PhraseBook::Number& number : phrases)
            number = numbers[number];
    }
};

}  // namespace dataflow::replay
