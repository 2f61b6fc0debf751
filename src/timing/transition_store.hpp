#pragma once
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "timing/transition.hpp"

namespace faster::timing {

/// Transitions that are worth remembering, by number. What is looked at often lies side by side.
class TransitionStore {
  public:
    using Number = std::uint32_t;

    struct Brief {
        std::uint32_t cycles;
        std::uint8_t entered;  ///< members that entered a loop, a bit each
        bool notable;          ///< something besides to take down: see notes()
    };
    /// Of the loops that members are in.
    struct Tally {
        std::array<std::uint16_t, Transition::most_members> iterations;  ///< of the entry at hand, by member
        std::uint16_t entered;                                           ///< members that entered one, a bit each
    };
    struct Notes {
        std::uint32_t froze;
        std::vector<Transition::Room> rooms;
    };
    template <class Element> struct Range {
        Element const* first;
        Element const* last;
        Element const* begin() const { return first; }
        Element const* end() const { return last; }
    };

    /// Whether there is room for it, and for its figures.
    bool accepts(Transition const& transition) const;
    Number add(Transition const& transition);
    std::size_t size() const { return briefs_.size(); }

    Brief brief(Number number) const { return briefs_[number]; }
    Tally const& tally(Number number) const { return tallies_[number]; }
    Range<Transition::Growth> growth(Number number) const { return part(growth_, growth_ends_, number); }
    Range<Transition::Peak> peaks(Number number) const { return part(peaks_, peaks_ends_, number); }
    Range<Transition::Stand> stands(Number number) const { return part(stands_, stands_ends_, number); }
    Notes const& notes(Number number) const { return notes_.at(number); }
    std::vector<TrailEvent> const& trail(Number number) const { return trails_[number]; }

    static bool is_notable(Transition const& transition) { return transition.froze != 0 || !transition.rooms.empty(); }

  private:
    template <class Element>
    static Range<Element> part(std::vector<Element> const& all, std::vector<std::uint32_t> const& ends, Number number) {
        std::uint32_t const begin = number == 0 ? 0 : ends[number - 1];
        return {all.data() + begin, all.data() + ends[number]};
    }

    std::vector<Brief> briefs_;
    std::vector<Tally> tallies_;
    std::vector<Transition::Growth> growth_;
    std::vector<std::uint32_t> growth_ends_;
    std::vector<Transition::Peak> peaks_;
    std::vector<std::uint32_t> peaks_ends_;
    std::vector<Transition::Stand> stands_;
    std::vector<std::uint32_t> stands_ends_;
    std::unordered_map<Number, Notes> notes_;
    std::vector<std::vector<TrailEvent>> trails_;
};

}  // namespace faster::timing
