#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/time/lead.hpp"
#include "dataflow/core/time/trail.hpp"
#include "dataflow/lookup/figure_block.hpp"

namespace dataflow::timing {

/// What a phrase of a group's driver does, from a relative state of the group on. Times are relative to the driver's
/// local time at the end; those of the trail, to that at the begin.
struct Transition {
    static constexpr unsigned most_members = Lead::most_members;

    /// Of a follower, at the end: what it waits for in its step. Behind it those that say which waits of that step it
    /// has been charged with and are over, in the order of ports.
    struct Stand {
        std::int32_t since;    ///< or until when it waited
        std::int32_t arrival;  ///< at the step
        std::int16_t port;     ///< waited for since then; -1: none
        std::uint8_t member;
        bool arrived;  ///< has come to the step by this transition
        bool is_over;
    };
    struct Room {  ///< cycles from which a frozen writer will find room
        unsigned fifo;
        bool all;
        std::vector<std::int64_t> from;
    };
    /// What few transitions have to tell.
    struct Notes {
        std::uint32_t froze = 0;  ///< members, a bit each
        std::vector<Room> rooms;
        std::vector<std::int64_t> fed;  ///< cycles of the supplier's iterations, if it takes from memory

        bool is_empty() const { return froze == 0 && rooms.empty() && fed.empty(); }
        void clear() {
            froze = 0;
            rooms.clear();
            fed.clear();
        }
    };

    Cycles cycles = 0;
    std::uint32_t entered = 0;                             ///< members that entered a loop, a bit each
    std::array<std::uint64_t, most_members> iterations{};  ///< of the loop entry at hand, by member
    FigureBlocks figures;
    std::vector<Stand> stands;
    Notes notes;
    std::vector<TrailEvent> trail;

    /// Becomes empty, and keeps its storage.
    void clear() {
        cycles = 0;
        entered = 0;
        iterations.fill(0);
        figures.clear();
        stands.clear();
        notes.clear();
        trail.clear();
    }
};

}  // namespace dataflow::timing
