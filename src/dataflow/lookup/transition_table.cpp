#include "dataflow/lookup/transition_table.hpp"

namespace dataflow::timing {

TransitionTable::Slot const* TransitionTable::add(Slot const& slot) {
    if (++size_ * 3 > slots_.size() * 2)
        grow();
    return put(slot);
}

TransitionTable::Slot const* TransitionTable::put(Slot const& slot) {
    std::size_t const mask = slots_.size() - 1;
    std::size_t i = slot.print.first & mask;
    while (slots_[i].number != none)
        i = (i + 1) & mask;
    slots_[i] = slot;
    return &slots_[i];
}

void TransitionTable::grow() {
    std::vector<Slot> old(slots_.size() * 2);
    old.swap(slots_);
    for (Slot const& slot : old)
        if (slot.number != none)
            put(slot);
}

}  // namespace dataflow::timing
