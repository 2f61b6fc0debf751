#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "dataflow/core/time/lead.hpp"
#include "dataflow/phrases/hash_table.hpp"
#include "dataflow/phrases/phrase.hpp"

namespace dataflow::timing {

/// Numbers the phrases of a group, for many uses of each. Of its supplier, which is ahead by as much as a FIFO holds,
/// they only say how often the driver reads from it.
class PhraseBook {
  public:
    using Number = std::uint32_t;

    struct Entry {
        std::uint32_t begin;  ///< of its codes
        std::uint32_t size;
        std::uint32_t active;  ///< members that do something, a bit each
        std::uint32_t due;     ///< accesses by the driver of what the supplier writes
        std::uint32_t first_piece = 0;
        std::uint32_t pieces = 0;  ///< 0: it was not cut
    };

    /// How phrases are told from each other. Whoever wrote a file may have made prints equal.
    enum class Compare { prints, codes };

    /// Of a phrase that was read with the supplier left out.
    Number number_of(Phrase const& phrase, Group const& group, Compare compare = Compare::codes);
    /// Of a phrase of another book, of the same group.
    Number number_of(PhraseBook const& other, Number number);
    /// Of all phrases of another book, by their numbers there.
    std::vector<Number> numbers_of(PhraseBook const& other);
    std::optional<Number> find(Phrase const& phrase) const;
    void clear();
    /// About as many as the phrases take.
    std::size_t bytes() const {
        return codes_.size() * sizeof(Phrase::Code) + entries_.size() * sizeof(Entry) + pieces_.size() * sizeof(Number);
    }
    std::size_t size() const { return entries_.size(); }
    Entry const& operator[](Number number) const { return entries_[number]; }
    Phrase::Code const* codes(Number number) const { return codes_.data() + entries_[number].begin; }
    /// Phrases that do the same one after the other.
    Number const* pieces(Number number) const { return pieces_.data() + entries_[number].first_piece; }
    void set_pieces(Number number, std::vector<Number> const& pieces);

  private:
    static constexpr Number none = ~Number{0};
    struct Numbered {
        static constexpr Number none = PhraseBook::none;

        Print print;
        Number number = none;

        std::uint64_t hash() const { return print.first; }
    };
    Number number_of(Phrase const& phrase, std::uint32_t due, Compare compare);
    Numbered const* find(Phrase const& phrase, Print const& print, Compare compare) const;
    bool is(Number number, Phrase const& phrase) const;

    std::vector<Phrase::Code> codes_;
    std::vector<Entry> entries_;
    std::vector<Number> pieces_;
    HashTable<Numbered> numbers_{1024};
};

/// What a group does next: phrases, by their numbers in a book. The supplier's operations are in its log.
struct Script {
    PhraseBook const* book = nullptr;
    PhraseBook::Number const* next = nullptr;
    PhraseBook::Number const* end = nullptr;
    std::uint64_t due = 0;  ///< of all phrases left
    /// Ports of the step that each follower goes on with; by member.
    std::array<Ports::Number, Lead::most_members> next_ports{};

    bool done() const { return next == end; }
};

/// Appends the next phrase of a script to the logs of a group.
void write_next(Group const& group, Script& script);

}  // namespace dataflow::timing
