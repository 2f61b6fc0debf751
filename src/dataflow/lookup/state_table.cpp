#include "dataflow/lookup/state_table.hpp"

#include <cstring>

namespace dataflow::timing {

namespace {
std::uint64_t mixed(std::uint64_t hash, std::uint64_t bits) {
    hash = (hash ^ bits) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 29);
}

/// Two of them.
std::uint64_t bits_of(StateWord const* words) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, words, sizeof(bits));
    return bits;
}
}  // namespace

/// Four hashes, none of which has to wait for the others.
std::uint64_t StateTable::hash_of(StateView state) {
    constexpr std::size_t lanes = 4;
    constexpr std::size_t step = sizeof(std::uint64_t) / sizeof(StateWord);
    std::uint64_t hashes[lanes] = {state.size, 1, 2, 3};
    std::size_t i = 0;
    for (; i + lanes * step <= state.size; i += lanes * step)
        for (std::size_t lane = 0; lane < lanes; ++lane)
            hashes[lane] = mixed(hashes[lane], bits_of(state.words + i + lane * step));
    for (; i + step <= state.size; i += step)
        hashes[0] = mixed(hashes[0], bits_of(state.words + i));
    if (i < state.size)
        hashes[0] = mixed(hashes[0], static_cast<std::uint32_t>(state.words[i]));
    for (std::size_t lane = 1; lane < lanes; ++lane)
        hashes[0] = mixed(hashes[0], hashes[lane]);
    return hashes[0];
}

bool StateTable::equal(StateView one, StateView other) {
    return one.size == other.size && std::memcmp(one.words, other.words, one.size * sizeof(StateWord)) == 0;
}

StateTable::Number StateTable::number_of(StateView state) {
    std::uint64_t const hash = hash_of(state);
    Numbered const* const known = numbers_.find(
        hash, [&](Numbered const& other) { return other.state_hash == hash && equal(states_[other.number], state); });
    if (known != nullptr)
        return known->number;
    if (states_.size() >= most_)
        return none;
    auto const number = static_cast<Number>(states_.size());
    states_.emplace_back(words_.keep(state.words, state.size), state.size);
    numbers_.add({hash, number});
    return number;
}

}  // namespace dataflow::timing
