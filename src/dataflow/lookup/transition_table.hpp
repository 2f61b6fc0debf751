#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/phrases/print.hpp"

namespace dataflow::timing {

/// Finds transitions by their print, a number of 128 bits, in an open-addressing hash table.
class TransitionTable {
  public:
    using Number = std::uint32_t;
    static constexpr Number none = ~0U;

    /// All of a transition that is looked at every time, in half a cache line.
    struct alignas(32) Slot {
        Print print{0, 0};
        Number number = none;
        Number next = none;        ///< state after the transition
        std::uint32_t cycles = 0;  ///< that it takes
        std::uint8_t entered = 0;  ///< members that entered a loop, a bit each
        bool notable = false;      ///< something besides time to take down
    };

    /// Null if the print is not known.
    Slot const* find(Print const& print) const {
        std::size_t const mask = slots_.size() - 1;
        for (std::size_t i = print.first & mask; slots_[i].number != none; i = (i + 1) & mask)
            if (slots_[i].print.first == print.first && slots_[i].print.second == print.second)
                return &slots_[i];
        return nullptr;
    }

    /// Adds what is not there yet. The slot stays where it is until the next call.
    Slot const* add(Slot const& slot);

  private:
    Slot const* put(Slot const& slot);
    void grow();

    std::size_t size_ = 0;
    std::vector<Slot> slots_ = std::vector<Slot>(1U << 8);
};

}  // namespace dataflow::timing
