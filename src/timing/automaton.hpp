#pragma once
#include <array>
#include <cstdint>
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

    /// How often each transition was used by one core, and not yet entered in its counters.
    using Ledger = std::vector<std::uint32_t>;

    /// Moves the driver and its followers on by as many phrases as possible. The followers must have got as far as they
    /// can without the driver.
    Progress follow(Group const& group, Ledger& ledger);

    /// Enters what the ledger holds in the counters of the core's processes and FIFOs, and empties it.
    void settle(Group const& group, Ledger& ledger) const;

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
    static constexpr unsigned most_members = 8;
    using Iterations = std::array<std::uint32_t, most_members>;  ///< of the loop entry at hand, by member

    /// What is looked at now and then.
    struct Account {
        std::uint32_t entered = 0;  ///< members that entered a loop, a bit each
        std::uint32_t froze = 0;
        std::vector<Growth> growth;
        std::vector<Stand> stands;
        std::vector<Room> rooms;
        bool is_plain() const { return entered == 0 && froze == 0 && rooms.empty(); }
    };
    /// What is looked at all the time: a cache line.
    struct Transition {
        Cycles cycles = 0;
        std::uint32_t key = 0;  ///< where in keys_: the state before, and the phrase
        std::uint16_t key_size = 0;
        bool plain = true;  ///< nothing but time passes
        std::uint32_t next = unnumbered;
        Iterations iterations{};
    };
    struct Slot {
        std::uint32_t tag = 0;         ///< upper half of the hash
        std::uint32_t transition = 0;  ///< number + 1; 0: free
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
        std::vector<std::uint32_t> history;  ///< numbers of transitions
        std::vector<Transition> loose;       ///< not worth remembering; numbers from first_loose on
        std::vector<Account> loose_accounts;
        std::vector<Stand> entry;  ///< of each follower, in absolute cycles
        std::vector<std::vector<Cycles>> rooms;
        std::array<std::uint64_t, most_members> iterations{};
    };
    static constexpr std::uint32_t first_loose = 1U << 31;
    static constexpr std::uint32_t none = ~0U;

    bool begin(Group const& group);
    void end(Group const& group);
    void apply(std::uint32_t number, Ledger& ledger);
    void apply_account(Transition const& taken, Account const& account);
    std::uint32_t find(std::uint64_t hash) const;
    bool is_key_of(Transition const& transition) const;
    std::uint32_t work_out(std::uint64_t hash);
    void describe(std::vector<std::uint64_t> const& before, std::vector<Cycles> const& loaded, Account& account);
    void describe_stands(std::vector<Cycles> const& loaded, Account& account);
    void describe_rooms(Account& account);
    std::uint32_t remember(Transition transition, Account&& account, std::uint64_t hash);
    Transition const& transition(std::uint32_t number) const {
        return number < first_loose ? transitions_[number] : session_.loose[number - first_loose];
    }
    Account const& account(std::uint32_t number) const {
        return number < first_loose ? accounts_[number] : session_.loose_accounts[number - first_loose];
    }
    void restore_stands(RelativeState& real);
    std::uint64_t hash_of_phrase() const;
    std::uint32_t number_of(Words const& words);
    void put_into_table(std::uint64_t hash, std::uint32_t number);

    Phrase phrase_;
    Session session_;
    bool decided_ = false;
    bool usable_ = false;
    bool driver_is_regular_ = false;
    std::unique_ptr<CoreTiming> bench_core_;
    std::unique_ptr<Group> bench_group_;
    std::unique_ptr<RelativeState> bench_;

    std::unordered_map<Words, std::uint32_t, WordsHash> numbers_;
    std::vector<Words const*> states_;
    std::vector<Transition> transitions_;
    std::vector<Account> accounts_;
    std::vector<Phrase::Code> keys_;
    std::vector<std::uint64_t> hashes_;  ///< of the transitions
    std::vector<Slot> table_ = std::vector<Slot>(1U << 14);
    Words words_;
    std::uint64_t phrases_ = 0;
    std::uint64_t worked_out_ = 0;
};

}  // namespace faster::timing
