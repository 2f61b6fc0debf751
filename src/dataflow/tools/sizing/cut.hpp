#pragma once
#include <algorithm>
#include <limits>
#include <vector>

#include "dataflow/tools/sizing/fifo_choice.hpp"

namespace dataflow::sizing {

/// Why choices are too slow: a path through the time of one core that turns at the FIFOs of the members. A choice
/// escapes only if one of the members differs from what the path needs; all others take `total_cycles` at least.
struct Cut {
    static constexpr Cycles deadlock = std::numeric_limits<Cycles>::max();

    struct Member {
        std::size_t fifo = 0;        ///< its number
        std::uint64_t capacity = 0;  ///< the path waits for room in a FIFO of this capacity; 0: it does not
        bool is_slow = false;        ///< the path waits for tokens that take two cycles

        /// More room, or fewer cycles.
        bool lets_escape(FifoChoice const& choice) const {
            return (capacity > 0 && choice.capacity() > capacity) || (is_slow && choice.read_latency() < 2);
        }
    };

    std::vector<Member> members;
    Cycles total_cycles = 0;  ///< deadlock: no choice without an escape ever ends

    bool is_escaped(Choice const& choice) const {
        return std::any_of(members.begin(), members.end(),
                           [&choice](Member const& member) { return member.lets_escape(choice[member.fifo]); });
    }
};

}  // namespace dataflow::sizing
