#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace faster::timing {

/// A group's state as a list of words, so that equal lists have equal futures: of each process its time, its flags, its
/// delay line and its log; of each FIFO its counts, and times. Times are relative to the driver's local time.
using StateWord = std::int32_t;
using StateWords = std::vector<StateWord>;

/// Times further apart make no state.
constexpr std::int64_t furthest_apart = std::int64_t{1} << 28;

/// The same, wherever it is.
struct StateView {
    StateWord const* words = nullptr;
    std::size_t size = 0;

    StateView() = default;
    StateView(StateWord const* first, std::size_t count) : words(first), size(count) {}
    // NOLINTNEXTLINE(google-explicit-constructor): what a view is for
    StateView(StateWords const& list) : words(list.data()), size(list.size()) {}
};

/// What a process's words besides its time, its delay line and its log say.
struct ProcessFlags {
    static constexpr unsigned words = 2;
    static constexpr std::uint64_t most_begun = 0xFF;

    unsigned loop = 0;            ///< that it is in, from 1 on; 0: none
    std::uint64_t begun = 0;      ///< iterations of it, up to as many as count
    std::uint8_t next_ports = 0;  ///< of the step it goes on with; 0: unknown
    bool frozen = false;
    unsigned waits_at = 0;  ///< port at which it is parked, from 1 on; 0: none
    std::size_t left = 0;   ///< operations in its log

    StateWord* put(StateWord* to) const {
        auto const bits = loop | static_cast<std::uint32_t>(begun << 7U) | (std::uint32_t{next_ports} << 15U) |
                          (waits_at << 23U) | (std::uint32_t{frozen} << 27U);
        to[0] = static_cast<StateWord>(bits);
        to[1] = static_cast<StateWord>(left);
        return to + words;
    }
    static ProcessFlags of(StateWord const* from) {
        auto const bits = static_cast<std::uint32_t>(from[0]);
        ProcessFlags flags;
        flags.loop = bits & 0x7F;
        flags.begun = (bits >> 7U) & most_begun;
        flags.next_ports = static_cast<std::uint8_t>(bits >> 15U);
        flags.waits_at = (bits >> 23U) & 0xF;
        flags.frozen = ((bits >> 27U) & 1U) != 0;
        flags.left = static_cast<std::size_t>(from[1]);
        return flags;
    }
};

/// What a FIFO's words besides its times say. Times that have no effect any more are only counted.
struct FifoCounts {
    static constexpr unsigned words = 2;
    static constexpr std::uint64_t most_tokens = 0xFFFF;

    std::uint64_t tokens = 0;
    std::uint64_t tokens_over = 0;  ///< of them, that can be read whenever their reader gets to them
    std::uint64_t room_over = 0;    ///< writes that wait for nothing

    StateWord* put(StateWord* to) const {
        to[0] = static_cast<StateWord>(tokens | (tokens_over << 16U));
        to[1] = static_cast<StateWord>(room_over);
        return to + words;
    }
    static FifoCounts of(StateWord const* from) {
        auto const bits = static_cast<std::uint32_t>(from[0]);
        return {bits & most_tokens, bits >> 16U, static_cast<std::uint64_t>(from[1])};
    }
};

/// An operation left in a log is two words.
constexpr unsigned words_of_operation = 2;
inline StateWord* put_code(std::uint64_t code, StateWord* to) {
    to[0] = static_cast<StateWord>(static_cast<std::uint32_t>(code));
    to[1] = static_cast<StateWord>(static_cast<std::uint32_t>(code >> 32U));
    return to + words_of_operation;
}
inline std::uint64_t code_of(StateWord const* from) {
    return static_cast<std::uint32_t>(from[0]) | (std::uint64_t{static_cast<std::uint32_t>(from[1])} << 32U);
}

}  // namespace faster::timing
