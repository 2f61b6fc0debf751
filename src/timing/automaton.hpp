#pragma once
#include <cstdint>
#include <deque>
#include <memory>
#include <unordered_map>
#include <vector>

#include "timing/phrase.hpp"
#include "timing/relative_state.hpp"

namespace faster::timing {

class CoreTiming;

/// Remembers how a group of processes answers to what its driver does. The relative state of the group decides, with the
/// next phrase of operations, how long that takes, what it costs whom, and the state after it; each such transition is
/// worked out once, operation by operation on a core of its own, and looked up from then on. Exact: equal states have
/// equal futures. May be shared by cores of the same shape.
class Automaton {
  public:
    struct Progress {
        bool moved = false;  ///< took some phrases
        bool later = false;  ///< stopped where some process has not said yet what it does, not at something foreign
    };

    Automaton();
    ~Automaton();

    /// Whether a core can be followed at all. The first core asked about gives the shape.
    bool fits(CoreTiming const& core, Lead const& lead, Group const& group);

    /// Moves the driver and its followers on by as many phrases as possible. The followers must have got as far as they
    /// can without the driver.
    Progress follow(Group const& group);

    std::size_t states() const { return states_.size(); }
    std::size_t transitions() const { return transitions_.size(); }
    std::uint64_t phrases() const { return phrases_; }

  private:
    using Words = RelativeState::Words;
    static constexpr std::uint32_t unnumbered = ~0U;

    struct Growth {
        std::uint32_t counter;
        std::uint64_t amount;
    };
    struct Stand {  ///< of a follower, at the end of a transition, relative to the driver
        unsigned member;
        std::int64_t since;
        std::int64_t arrival;
        bool arrived;
    };
    struct Room {  ///< cycles from which a frozen writer will find room, relative to the driver
        unsigned fifo;
        bool all;
        std::vector<std::int64_t> from;
    };
    struct Transition {
        std::vector<Phrase::Code> key;  ///< state before, and the phrase
        std::uint32_t next = unnumbered;
        Cycles cycles = 0;
        std::uint32_t uses = 0;  ///< in the session at hand
        std::uint32_t entered = 0;  ///< members that entered a loop, a bit each
        std::uint32_t froze = 0;
        std::vector<Growth> growth;
        std::vector<Stand> stands;
        std::vector<Room> rooms;
        std::vector<std::uint64_t> iterations;  ///< of the loop entry at hand, by member
    };
    struct Slot {
        std::uint64_t hash = 0;
        Transition* transition = nullptr;
    };
    struct WordsHash {
        std::size_t operator()(Words const& words) const;
    };
    /// One following of a group: from where it stood to where it stopped.
    struct Session {
        std::uint32_t state = unnumbered;
        Words words;  ///< of the state, if it has no number
        Cycles time = 0;
        std::uint32_t frozen = 0;
        std::vector<Transition*> history;
        std::vector<Transition*> used;
        std::deque<Transition> loose;  ///< not worth remembering
        std::vector<Stand> entry;      ///< of each follower, in absolute cycles
        std::vector<std::vector<Cycles>> rooms;
        std::vector<std::uint64_t> iterations;  ///< of each member, at the entry
        std::vector<std::size_t> entered;       ///< index into the history + 1 of the last that entered a loop
    };

    bool begin(Group const& group);
    void end(Group const& group);
    void apply(Transition& transition);
    Transition* find(std::uint64_t hash) const;
    Transition* work_out(std::uint64_t hash);
    void describe(std::vector<std::uint64_t> const& before, std::vector<Cycles> const& loaded, Transition& transition);
    void describe_stands(std::vector<Cycles> const& loaded, Transition& transition);
    void describe_rooms(Transition& transition);
    void restore_stands(RelativeState& real);
    void restore_iterations(RelativeState& real);
    std::uint64_t hash_of_phrase() const;
    std::uint32_t number_of(Words const& words);
    void put_into_table(Slot const& slot);
    void forget_all();

    Phrase phrase_;
    Session session_;
    bool decided_ = false;
    bool usable_ = false;
    std::unique_ptr<CoreTiming> bench_core_;
    std::unique_ptr<Group> bench_group_;
    std::unique_ptr<RelativeState> bench_;

    std::unordered_map<Words, std::uint32_t, WordsHash> numbers_;
    std::vector<Words const*> states_;
    std::deque<Transition> transitions_;
    std::vector<Slot> table_;
    Words words_;
    std::uint64_t phrases_ = 0;
    std::uint64_t worked_out_ = 0;
};

}  // namespace faster::timing
