#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "timing/phrase.hpp"
#include "timing/relative_state.hpp"
#include "timing/transition_table.hpp"

namespace faster::timing {

class CoreTiming;

/// Remembers how a group of processes answers to what its driver does. The relative state of the group decides, with
/// the next phrase of operations, how long that takes, what it costs whom, and the state after it; each such transition
/// is worked out once, operation by operation on a core of its own, and looked up from then on. Exact: equal states
/// have equal futures. May be shared by cores of the same shape.
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

    struct Session;

    /// Moves the driver and its followers on by as many phrases as possible. The followers must have got as far as they
    /// can without the driver. The session is the core's own.
    Progress follow(Group const& group, Session& session);

    /// Enters what the session still holds in the counters of the core's processes and FIFOs.
    void settle(Group const& group, Session& session) const;

    /// From now on, tells the trails of the cores what decides their times. Before the first is followed.
    void leave_trails() { leaves_trails_ = true; }
    /// What a transition that is remembered takes, and what decides it, from its begin on.
    Cycles cycles(std::uint32_t transition) const { return accounts_[transition].cycles; }
    std::vector<TrailEvent> const& trail(std::uint32_t transition) const { return accounts_[transition].trail; }

    /// The core cannot be followed, or repeats itself too rarely.
    bool gave_up() const { return decided_ && !usable_; }
    std::size_t states() const { return states_.size(); }
    std::size_t transitions() const { return accounts_.size(); }
    std::uint64_t phrases() const { return phrases_; }

  private:
    using Words = RelativeState::Words;
    using Number = TransitionTable::Number;
    static constexpr Number none = TransitionTable::none;
    static constexpr Number first_loose = 1U << 31;
    static constexpr unsigned most_members = 8;

    struct Growth {
        std::uint32_t counter;
        std::uint64_t amount;
    };
    struct Stand {  ///< of a follower, at the end of a transition, relative to the driver
        unsigned member;
        std::int64_t since;
        std::int64_t arrival;
        unsigned port;  ///< waited for since then
        bool arrived;
    };
    struct Room {  ///< cycles from which a frozen writer will find room, relative to the driver
        unsigned fifo;
        bool all;
        std::vector<std::int64_t> from;
    };
    struct Account {
        Cycles cycles = 0;
        std::uint32_t entered = 0;  ///< members that entered a loop, a bit each
        std::uint32_t froze = 0;
        std::array<std::uint64_t, most_members> iterations{};  ///< of the loop entry at hand, by member
        std::vector<Growth> growth;
        std::vector<Stand> stands;
        std::vector<Room> rooms;
        std::vector<TrailEvent> trail;
    };
    using Slot = TransitionTable::Slot;
    using Print = TransitionTable::Print;
    struct WordsHash {
        std::size_t operator()(Words const& words) const;
    };

    bool begin(Group const& group);
    void end(Group const& group);
    void apply(Slot const& slot);
    void note(Account const& account);
    Slot const* work_out(Print const& print);
    /// Where the members stood before a transition.
    struct Before {
        std::vector<std::uint64_t> counters;
        std::vector<Cycles> times;
        std::vector<unsigned> ports;  ///< waited for
    };
    void describe(Before const& before, Account& account);
    void describe_stands(Before const& before, Account& account);
    void describe_rooms(Account& account);
    Account const& account(Session const& session, Number number) const;
    void restore_stands(RelativeState& real);
    std::vector<TrailEvent> take_trail();
    void extend(Trail& trail) const;
    void add_iterations(Group const& group, Session& session) const;
    Print print_of_phrase() const;
    Number number_of(Words const& words);

    Phrase phrase_;
    Session* session_ = nullptr;  ///< at hand
    bool decided_ = false;
    bool usable_ = false;
    bool driver_is_regular_ = false;
    bool leaves_trails_ = false;
    std::unique_ptr<CoreTiming> bench_core_;
    std::unique_ptr<Group> bench_group_;
    std::unique_ptr<RelativeState> bench_;
    std::vector<std::uint64_t*> bench_counters_;

    std::unordered_map<Words, std::uint32_t, WordsHash> numbers_;
    std::vector<Words const*> states_;
    std::vector<Account> accounts_;
    TransitionTable table_;
    Slot once_;  ///< the last that was not worth remembering
    Words words_;
    std::uint64_t phrases_ = 0;
    std::uint64_t worked_out_ = 0;
    std::uint64_t worked_out_before_ = 0;  ///< the trial at hand
    std::uint64_t next_trial_ = 0;
};

/// One following of a group: from where it stood to where it stopped. And what is to be entered in its counters.
struct Automaton::Session {
    Number state = none;
    Words words;  ///< of the state, if it has no number
    Cycles begin = 0;
    Cycles time = 0;
    std::uint32_t frozen = 0;
    std::vector<Number> history;  ///< of accounts
    std::vector<Account> loose;   ///< not worth remembering; numbers from first_loose on
    std::vector<Stand> entry;     ///< of each follower, in absolute cycles
    std::vector<std::vector<Cycles>> rooms;
    std::vector<std::uint64_t> iterations;  ///< of each member's loop, before the session
    std::vector<std::uint64_t> entries;     ///< of loops by each member, when the session stopped
    std::vector<std::uint32_t> uses;        ///< of each account, in all sessions
};

}  // namespace faster::timing
