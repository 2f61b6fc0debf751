#pragma once
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace faster::timing {

/// Finds the transition from a numbered state by a numbered phrase: an open-addressing hash table of 8 bytes a slot, at
/// most half full, so that nearly every look-up ends at the first slot and what is asked for most is near. The hash of
/// a key can be undone, so a slot need not say what its place tells already.
class NumberedTransitions {
    // The mark, the next state, the transition; the mark: by how many places it is behind its own, and a tag.
    using Slot = std::uint64_t;

  public:
    using Number = std::uint32_t;

    struct Known {
        Number next = 0;       ///< state after the transition
        Number number = none;  ///< of the transition
        explicit operator bool() const { return number != none; }
        static constexpr Number none = ~Number{0};
    };

    /// For many look-ups in a row, until something is added: fits into registers.
    class Reader {
      public:
        explicit Reader(NumberedTransitions const& table) : slots_(table.slots_.data()), tag_bits_(table.tag_bits_) {}

        /// False if it is not known.
        Known find(Number state, Number phrase) const {
            if ((state | phrase) > low(number_bits))
                return {};
            std::uint64_t const hash = hash_of(state, phrase);
            Slot const* slot = slots_ + (hash >> tag_bits_);
            std::uint64_t mark = hash & low(tag_bits_);
            for (; *slot >> mark_at != mark; ++slot, mark += a_place_on)
                if (*slot == empty)
                    return {};
            return {static_cast<Number>((*slot >> number_bits) & low(number_bits)),
                    static_cast<Number>(*slot & low(number_bits))};
        }

      private:
        Slot const* slots_;
        unsigned tag_bits_;
    };

    /// Adds what is not there yet. Numbers beyond what a slot can tell are not remembered, nor is what would be too far
    /// from its place: it has to be worked out again.
    void add(Number state, Number phrase, Known const& known) {
        if ((state | phrase | known.next | known.number) > low(number_bits))
            return;
        if (++size_ * 2 > slots_.size())
            grow();
        std::uint64_t const rest = std::uint64_t{known.next} << number_bits | known.number;
        while (!put(hash_of(state, phrase), rest) && slots_.size() < size_ * sparse)
            grow();
    }

  private:
    static constexpr unsigned number_bits = 18;
    static constexpr unsigned key_bits = 2 * number_bits;
    static constexpr unsigned mark_at = 2 * number_bits;
    static constexpr unsigned most_tag_bits = 23;
    static constexpr std::uint64_t a_place_on = std::uint64_t{1} << most_tag_bits;
    static constexpr std::size_t furthest = 30;  // places behind its own; no slot is all ones
    static constexpr Slot empty = ~Slot{0};
    static constexpr std::size_t sparse = 64;  // slots for each transition: more would not help

    static constexpr std::uint64_t low(unsigned bits) { return (std::uint64_t{1} << bits) - 1; }
    /// Multiplied with an odd number, modulo a power of two: no two are equal.
    static std::uint64_t hash_of(Number state, Number phrase) {
        std::uint64_t const key = std::uint64_t{state} << number_bits | phrase;
        return (key * 0x9E3779B97U) & low(key_bits);
    }
    /// False: it would be too far from its place.
    bool put(std::uint64_t hash, std::uint64_t rest) {
        Slot* slot = slots_.data() + (hash >> tag_bits_);
        std::uint64_t mark = hash & low(tag_bits_);
        for (std::size_t i = 0; i <= furthest; ++i, ++slot, mark += a_place_on)
            if (*slot == empty) {
                *slot = mark << mark_at | rest;
                return true;
            }
        return false;
    }
    /// Forgets what would be too far from its new place, if there is any.
    void grow() {
        std::vector<Slot> old = std::move(slots_);
        unsigned const bits = tag_bits_--;
        slots_ = std::vector<Slot>(slots_for(tag_bits_), empty);
        for (std::size_t i = 0; i < old.size(); ++i) {
            if (old[i] == empty)
                continue;
            std::uint64_t const mark = old[i] >> mark_at;
            std::uint64_t const place = i - (mark >> most_tag_bits);
            put(place << bits | (mark & low(bits)), old[i] & low(mark_at));
        }
    }
    /// No look-up goes further than to the last, which is always empty.
    static std::size_t slots_for(unsigned tag_bits) { return (std::size_t{1} << (key_bits - tag_bits)) + furthest + 2; }

    std::size_t size_ = 0;
    unsigned tag_bits_ = most_tag_bits;
    std::vector<Slot> slots_ = std::vector<Slot>(slots_for(most_tag_bits), empty);
};

}  // namespace faster::timing
