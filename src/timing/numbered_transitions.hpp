#pragma once
#include <cstdint>
#include <vector>

namespace faster::timing {

/// Finds the transition from a numbered state by a numbered phrase: an open-addressing hash table, of which nearly
/// every look-up touches one cache line.
class NumberedTransitions {
  public:
    using Number = std::uint32_t;

    struct alignas(16) Slot {
        std::uint64_t key = empty;  ///< state and phrase
        Number next = 0;            ///< state after the transition
        Number number = 0;          ///< of the transition
    };

    /// For many look-ups in a row, until something is added: fits into registers.
    class Reader {
      public:
        explicit Reader(NumberedTransitions const& table)
            : slots_(table.slots_.data()), mask_(table.mask_), shift_(table.shift_) {}

        /// Null if it is not known.
        Slot const* find(Number state, Number phrase) const {
            std::uint64_t const key = key_of(state, phrase);
            for (std::size_t i = place_of(key, shift_);; i = (i + 1) & mask_) {
                if (slots_[i].key == key)
                    return &slots_[i];
                if (slots_[i].key == empty)
                    return nullptr;
            }
        }

      private:
        Slot const* slots_;
        std::size_t mask_;
        unsigned shift_;
    };

    /// Adds what is not there yet. The slot stays where it is until the next call.
    Slot const* add(Number state, Number phrase, Number next, Number number) {
        if (++size_ * 4 > 3 * slots_.size())
            grow();
        return put({key_of(state, phrase), next, number});
    }

  private:
    static constexpr std::uint64_t empty = ~std::uint64_t{0};
    static std::uint64_t key_of(Number state, Number phrase) { return (std::uint64_t{state} << 32) | phrase; }
    static std::size_t place_of(std::uint64_t key, unsigned shift) { return (key * 0x9E3779B97F4A7C15U) >> shift; }
    Slot const* put(Slot const& slot) {
        std::size_t i = place_of(slot.key, shift_);
        while (slots_[i].key != empty)
            i = (i + 1) & mask_;
        slots_[i] = slot;
        return &slots_[i];
    }
    void grow() {
        std::vector<Slot> old(slots_.size() * 2);
        old.swap(slots_);
        --shift_;
        mask_ = slots_.size() - 1;
        for (Slot const& slot : old)
            if (slot.key != empty)
                put(slot);
    }

    std::size_t size_ = 0;
    unsigned shift_ = 52;
    std::vector<Slot> slots_ = std::vector<Slot>(std::size_t{1} << 12);
    std::size_t mask_ = slots_.size() - 1;
};

}  // namespace faster::timing
