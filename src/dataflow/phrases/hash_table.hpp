#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace dataflow::timing {

/// A hash table with open addressing. An Entry has a hash() and a `number`, which is Entry::none where there is none.
template <class Entry> class HashTable {
  public:
    /// Begins with so many places, a power of two.
    explicit HashTable(std::size_t places) : entries_(places) {}

    /// Of this hash, the one that `is_it`; null: it is not there.
    template <class IsIt> Entry const* find(std::uint64_t hash, IsIt const& is_it) const {
        std::size_t i = hash & mask();
        for (; entries_[i].number != Entry::none; i = (i + 1) & mask())
            if (is_it(entries_[i]))
                return &entries_[i];
        return nullptr;
    }
    /// Adds what is not there yet. It stays where it is until the next call.
    Entry const* add(Entry const& entry) {
        if (++size_ * 3 > entries_.size() * 2)
            grow();
        return put(entry);
    }
    void clear() {
        size_ = 0;
        entries_.assign(entries_.size(), Entry());
    }

  private:
    std::size_t mask() const { return entries_.size() - 1; }
    Entry const* put(Entry const& entry) {
        std::size_t i = entry.hash() & mask();
        while (entries_[i].number != Entry::none)
            i = (i + 1) & mask();
        entries_[i] = entry;
        return &entries_[i];
    }
    void grow() {
        std::vector<Entry> old(entries_.size() * 2);
        old.swap(entries_);
        for (Entry const& entry : old)
            if (entry.number != Entry::none)
                put(entry);
    }

    std::size_t size_ = 0;
    std::vector<Entry> entries_;
};

}  // namespace dataflow::timing
