#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/lookup/transition.hpp"
#include "dataflow/lookup/word_arena.hpp"

namespace dataflow::timing {

/// Transitions that are worth remembering, by number. What is looked at often lies side by side.
class TransitionStore {
  public:
    using Number = std::uint32_t;

    /// All of a transition that is looked at every time, in one word.
    class Brief {
      public:
        static constexpr Cycles most_cycles = (Cycles{1} << (31 - Transition::most_members)) - 1;

        Brief() = default;
        Brief(Cycles cycles, std::uint32_t entered, bool notable)
            : word_(static_cast<std::uint32_t>(cycles) << cycles_at | (notable ? is_notable : 0) | entered) {}

        std::uint32_t cycles() const { return word_ >> cycles_at; }
        /// Members that entered a loop, a bit each.
        std::uint32_t entered() const { return word_ & (is_notable - 1); }
        /// Something besides to take down: see notes().
        bool notable() const { return (word_ & is_notable) != 0; }
        /// Together with those of one before.
        Brief behind(Brief before) const {
            return {Cycles{cycles()} + before.cycles(), entered() | before.entered(), notable() || before.notable()};
        }

      private:
        static constexpr std::uint32_t is_notable = 1U << Transition::most_members;
        static constexpr unsigned cycles_at = Transition::most_members + 1;

        std::uint32_t word_ = 0;
    };
    /// Of the loops that members are in.
    struct Tally {
        std::array<std::uint16_t, Transition::most_members> iterations;  ///< of the entry at hand, by member
        std::uint16_t entered;                                           ///< members that entered one, a bit each
    };
    template <class Element> struct Range {
        Element const* first;
        Element const* last;
        Element const* begin() const { return first; }
        Element const* end() const { return last; }
    };

    TransitionStore();

    /// Whether there is room for it, and for its figures.
    bool accepts(Transition const& transition) const;
    Number add(Transition const& transition);
    /// Of transitions one after the other: one that does the same. Of its own it has a brief() and a tally(); all else
    /// is that of its pieces().
    bool accepts_sequence(std::vector<Number> const& transitions) const;
    Number add_sequence(std::vector<Number> const& transitions);
    std::size_t size() const { return briefs_.size(); }

    Brief brief(Number number) const { return briefs_[number]; }
    /// The transition itself, or those of which it is a sequence.
    Range<Number> pieces(Number number) const { return part(pieces_, &Ends::pieces, number); }
    static Range<Number> only(Number const& number) { return {&number, &number + 1}; }
    bool is_sequence(Number number) const { return *pieces(number).first != number; }
    Tally const& tally(Number number) const { return tallies_[number]; }
    /// Of no sequence: those of Transition.
    Range<FigureBlock> figures(Number number) const { return figures_[number]; }
    Range<Transition::Stand> stands(Number number) const { return part(stands_, &Ends::stands, number); }
    Transition::Notes const& notes(Number number) const { return notes_[places_of_notes_[number]]; }
    std::vector<TrailEvent> const& trail(Number number) const;

  private:
    /// Where a transition's share of what all have ends.
    struct Ends {
        std::uint32_t pieces;
        std::uint32_t stands;
    };
    template <class Element>
    Range<Element> part(std::vector<Element> const& all, std::uint32_t Ends::*end, Number number) const {
        std::uint32_t const begin = number == 0 ? 0 : ends_[number - 1].*end;
        return {all.data() + begin, all.data() + ends_[number].*end};
    }
    static void add(Tally const& next, Tally& sum);
    void end();

    std::vector<Brief> briefs_;
    std::vector<Tally> tallies_;
    std::vector<Ends> ends_;
    std::vector<Number> pieces_;
    WordArena<FigureBlock> kept_figures_;
    std::vector<Range<FigureBlock>> figures_;  ///< of a sequence: none
    std::vector<Transition::Stand> stands_;
    std::vector<Transition::Notes> notes_;
    std::vector<std::uint32_t> places_of_notes_;   ///< by transition, up to the last that has any
    std::vector<std::vector<TrailEvent>> trails_;  ///< up to the last that left any
};

}  // namespace dataflow::timing
