#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/lookup/state_words.hpp"
#include "dataflow/lookup/word_arena.hpp"

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
    struct Bucket {
        std::uint64_t hash = 0;
        Number number = none;
    };

    static std::uint64_t hash_of(StateView state);
    static bool equal(StateView one, StateView other);
    void grow();

    std::size_t most_;
    std::vector<StateView> states_;
    std::vector<Bucket> buckets_ = std::vector<Bucket>(2048);  ///< by hash: open addressing, a power of two
    WordArena<StateWord> words_;
};

}  // namespace dataflow::timing
