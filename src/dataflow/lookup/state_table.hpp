#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/lookup/state_words.hpp"
#include "dataflow/lookup/word_arena.hpp"
#include "dataflow/phrases/hash_table.hpp"

namespace dataflow::timing {

/// Numbers states, from 0 on: equal ones are one. Keeps their words, which stay where they are.
class StateTable {
  public:
    using Number = std::uint32_t;

    static constexpr Number none = ~Number{0};

    /// May have as many as `most`; then none for one that is not known.
    explicit StateTable(std::size_t most = none) : most_(most) {}

    Number number_of(StateView state);
    StateView operator[](Number number) const { return states_[number]; }
    std::size_t size() const { return states_.size(); }

  private:
    struct Numbered {
        static constexpr Number none = StateTable::none;

        std::uint64_t state_hash = 0;
        Number number = none;

        std::uint64_t hash() const { return state_hash; }
    };

    static std::uint64_t hash_of(StateView state);
    static bool equal(StateView one, StateView other);

    std::size_t most_;
    std::vector<StateView> states_;
    HashTable<Numbered> numbers_{2048};
    WordArena<StateWord> words_;
};

}  // namespace dataflow::timing
