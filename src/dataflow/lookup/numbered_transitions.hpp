#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace dataflow::timing {

/// Finds the transition from a numbered state by a numbered phrase: an open-addressing hash table of 8 bytes a slot, at
/// most half full, so that nearly every look-up ends at the first slot and what is asked for most is near. The hash of
/// a key can be undone, so a slot need not say what its place tells already. All numbers are below `numbers`.
class NumberedTransitions {
    static constexpr unsigned number_bits = 18;
    // The mark, the next state, the transition. The mark: a tag, and how many places it is behind its own.
    using Slot = std::uint64_t;

  public:
    using Number = std::uint32_t;
    static constexpr Number numbers = Number{1} << number_bits;

    struct Known {
        Number next = 0;       ///< state after the transition
        Number number = none;  ///< of the transition
        explicit operator bool() const { return number != none; }
        static constexpr Number none = ~Number{0};
    };

    /// A state, as it is in keys and in slots.
    using Row = std::uint64_t;
    static Row row_of(Number state) { return Row{state} << number_bits; }
    static Number state_of(Row row) { return static_cast<Number>(row >> number_bits); }

    /// For many look-ups in a row, until something is added: fits into registers.
    class Reader {
      public:
        explicit Reader(NumberedTransitions const& table) : slots_(table.slots_.data()), shift_(table.shift_) {}

        /// Goes on to the state after the transition, whose number it returns; none: it is not known.
        Number move(Row& row, Number phrase) const {
            std::uint64_t const hash = hash_of(row | phrase);
            Slot const* slot = slots_ + (hash >> shift_);
            for (std::uint64_t behind = 0; (*slot ^ tag_of(hash)) >> mark_at != behind;)
                if (*slot == empty || *++slot == empty || ++behind > furthest)
                    return Known::none;
            row = *slot & row_mask;
            return static_cast<Number>(*slot & (numbers - 1));
        }
        Known find(Number state, Number phrase) const {
            Row row = row_of(state);
            Number const number = move(row, phrase);
            return {state_of(row), number};
        }

      private:
        Slot const* slots_;
        unsigned shift_;
    };

    /// Adds what is not there yet. What would be too far from its place is not remembered: it has to be worked out
    /// again.
    void add(Number state, Number phrase, Known const& known) {
        if (++size_ * 2 > slots_.size())
            grow();
        std::uint64_t const rest = row_of(known.next) | known.number;
        while (!put(hash_of(row_of(state) | phrase), rest) && slots_.size() < size_ * sparse)
            grow();
    }

  private:
    static constexpr unsigned key_bits = 2 * number_bits;
    static constexpr unsigned mark_at = 2 * number_bits;
    static constexpr unsigned tag_bits = 23;
    static constexpr unsigned tag_at = 64 - tag_bits;
    static constexpr std::size_t furthest = (std::size_t{1} << (tag_at - mark_at)) - 2;  // no slot is all ones
    static constexpr Row row_mask = Row{numbers - 1} << number_bits;
    static constexpr Slot empty = ~Slot{0};
    static constexpr std::size_t sparse = 8;  // slots for each transition: more would not help

    /// Of a key, in the upper bits: multiplied with an odd number, modulo a power of two, so that no two are equal.
    static std::uint64_t hash_of(std::uint64_t key) { return key * (std::uint64_t{0x9E3779B97} << (64 - key_bits)); }
    /// All of a hash that its place does not tell, where slots have it.
    static std::uint64_t tag_of(std::uint64_t hash) { return hash << (key_bits - tag_bits); }
    /// False: it would be too far from its place.
    bool put(std::uint64_t hash, std::uint64_t rest) {
        Slot* slot = slots_.data() + (hash >> shift_);
        for (std::uint64_t behind = 0; behind <= furthest; ++behind, ++slot)
            if (*slot == empty) {
                *slot = tag_of(hash) | behind << mark_at | rest;
                return true;
            }
        return false;
    }
    /// Forgets what would be too far from its new place, if there is any.
    void grow() {
        std::vector<Slot> const old = std::move(slots_);
        unsigned const shift = shift_--;
        slots_ = std::vector<Slot>(slots_for(shift_), empty);
        for (std::size_t i = 0; i < old.size(); ++i) {
            if (old[i] == empty)
                continue;
            std::uint64_t const place = i - ((old[i] >> mark_at) & (furthest + 1));
            std::uint64_t const below = old[i] >> tag_at << (64 - key_bits);
            put((place << shift) | (below & ((std::uint64_t{1} << shift) - 1)), old[i] & (row_mask | (numbers - 1)));
        }
    }
    /// No look-up goes further than to the last, which is always empty.
    static std::size_t slots_for(unsigned shift) { return (std::size_t{1} << (64 - shift)) + furthest + 2; }

    static constexpr unsigned shift_at_first = 64 - (key_bits - tag_bits);

    std::size_t size_ = 0;
    unsigned shift_ = shift_at_first;  ///< of hashes: their places
    std::vector<Slot> slots_ = std::vector<Slot>(slots_for(shift_at_first), empty);
};

}  // namespace dataflow::timing
