#pragma once
#include <cstdint>
#include <vector>

namespace faster::timing {

/// Finds transitions by their print, a number of 128 bits, in an open-addressing hash table. They are numbered in the
/// order in which they come.
class TransitionTable {
  public:
    using Number = std::uint32_t;
    static constexpr Number none = ~0U;

    struct Print {
        std::uint64_t first;
        std::uint64_t second;
    };
    /// What the next look-up waits for: small.
    struct Slot {
        std::uint64_t print = 0;
        Number number = none;
        Number next = none;  ///< state after the transition
    };

    /// Null if the print is not known.
    Slot const* find(Print const& print) const {
        std::size_t const mask = slots_.size() - 1;
        for (std::size_t i = print.first & mask; slots_[i].number != none; i = (i + 1) & mask)
            if (slots_[i].print == print.first && second_prints_[slots_[i].number] == print.second)
                return &slots_[i];
        return nullptr;
    }

    /// Adds what is not there yet. The slot stays where it is until the next call.
    Slot const* add(Print const& print, Number next);
    std::size_t size() const { return second_prints_.size(); }

  private:
    Slot const* put(Slot const& slot);
    void grow();

    std::vector<std::uint64_t> second_prints_;  // by number
    std::vector<Slot> slots_ = std::vector<Slot>(1U << 12);
};

}  // namespace faster::timing
