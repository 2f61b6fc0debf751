#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "dataflow/base/uninitialized.hpp"
#include "dataflow/lookup/cut_trial.hpp"
#include "dataflow/lookup/numbered_transitions.hpp"
#include "dataflow/lookup/relative_state.hpp"
#include "dataflow/lookup/state_table.hpp"
#include "dataflow/lookup/transition.hpp"
#include "dataflow/lookup/transition_bench.hpp"
#include "dataflow/lookup/transition_slot.hpp"
#include "dataflow/lookup/transition_store.hpp"
#include "dataflow/phrases/hash_table.hpp"
#include "dataflow/phrases/phrase.hpp"
#include "dataflow/phrases/phrase_book.hpp"
#include "dataflow/phrases/phrase_core.hpp"

namespace dataflow::timing {

class CoreTiming;

/// Remembers how a group of processes answers to what its driver does. The relative state of the group decides, with
/// the next phrase of operations, how long that takes, what it costs whom, and the state after it; each such transition
/// is worked out once, operation by operation on a bench of its own, and looked up from then on. Exact: equal states
/// have equal futures. May be shared by cores of the same shape.
class Automaton : public Answers, public Passages {
  public:
    struct Progress {
        bool moved = false;  ///< took some phrases
        bool later = false;  ///< stopped where some process has not said yet what it does
    };

    Automaton();
    ~Automaton() override;
    Automaton(Automaton const&) = delete;
    Automaton& operator=(Automaton const&) = delete;

    /// Whether a core can be followed at all. The first core asked about gives the shape. `in_steps`: members of the
    /// group have loops of steps, see LoopsInSteps.
    bool fits(CoreTiming const& core, Lead const& lead, Group const& group, bool in_steps);

    struct Session;
    /// The following of a script by one core.
    struct Walk {
        Group const* group = nullptr;
        Session* session = nullptr;
        Script* script = nullptr;
        PhraseBook::Number const* begin = nullptr;
        PhraseBook::Number const* end = nullptr;      ///< of what can be walked
        PhraseBook::Number const* counted = nullptr;  ///< up to here, the session has all transitions in its figures
        std::uint64_t due_behind = 0;                 ///< of the phrases behind that
    };

    /// Moves the driver and its followers on by as many phrases as possible. The followers must have got as far as they
    /// can without the driver. The session is the core's own.
    Progress follow(Group const& group, Session& session);
    /// Begins to move them on by phrases of a script. Only where the script goes on: the driver's log is empty, and
    /// what is left in the logs of followers, but for suppliers, was asked for by the driver before. False if they
    /// cannot.
    bool set_out(Walk& walk);
    /// Moves walks that have set out on, until one is at its end or comes to what cannot be worked out: which. A
    /// look-up waits for the one before it in the same walk; those of several walks take turns.
    std::size_t go_on(std::vector<Walk*> const& walks);
    /// The walks of cores that are followed.
    std::size_t go_on(std::vector<PhraseCore*> const& cores) override;
    /// Ends a walk: moves the core to where it got. Whether it got anywhere.
    bool arrive(Walk& walk);
    static bool is_where_script_goes_on(Group const& group);

    /// Enters what the session still holds in the counters of the core's processes and FIFOs.
    void settle(Group const& group, Session& session) const;

    /// From now on, tells the trails of the cores what decides their times. Before the first is followed.
    void leave_trails() { leaves_trails_ = true; }
    /// What a transition that is remembered takes, and what decides it, from its begin on.
    Cycles cycles(std::uint32_t transition) const override { return store_.brief(transition).cycles(); }
    std::vector<TrailEvent> const& trail(std::uint32_t transition) const override { return store_.trail(transition); }

    /// The core cannot be followed, or repeats itself too rarely.
    bool gave_up() const { return decided_ && !usable_; }
    std::size_t states() const { return states_.size(); }
    std::size_t transitions() const { return store_.size(); }
    std::uint64_t phrases() const { return phrases_; }

  private:
    using Number = TransitionSlot::Number;
    static constexpr Number none = TransitionSlot::none;
    static constexpr Number first_loose = 1U << 31;
    using Stand = Transition::Stand;
    using Room = Transition::Room;
    using Slot = TransitionSlot;
    using History = std::vector<Number, Uninitialized<Number>>;

    bool is_far_apart(Group const& group) const;
    static bool goes_on_elsewhere(Group::Member const& member);
    static std::uint32_t going_on_elsewhere(Group const& group);
    bool is_worthwhile() const;
    bool is_recurring() const;
    bool begin(Group const& group, Script const* script = nullptr);
    bool find_outlooks(Group const& group, Script const* script, RelativeState& real);
    void end(Group const& group, Script* script = nullptr);
    void apply(Slot const& slot);
    void make_room_for_uses(Session& session) const;
    void note(Session& session, Number number, Cycles begin) const;
    static void note(Session& session, Transition::Notes const& notes, Cycles end);
    Phrase::Reading read(Group const& group, std::uint32_t frozen);
    static std::uint64_t fed_iterations(Group const& group);
    std::uint32_t supplies_of_phrase(Group const& group, std::uint32_t frozen) const;
    static std::uint64_t supplies_at_hand(Group::Member const& supplier);
    Slot const* find(Print const& print) const {
        return table_.find(print.first, [&](Slot const& slot) { return slot.print == print; });
    }
    Slot const* work_out(Print const& print, Group const& group);
    bool perform(StateView from);
    Number number_of_state();
    bool work_out(Slot& slot);
    void describe(Slot& slot) const;
    bool put_together(Walk const& walk, Slot& slot);
    NumberedTransitions::Known work_out_piece(Walk const& walk, Number state, PhraseBook::Number piece);
    bool take_up(Walk const& walk, PhraseBook::Number number);
    /// Where a walk is, while it goes on.
    struct Place {
        PhraseBook::Number const* phrases;  ///< that are left
        Number* history;                    ///< for their transitions
        std::size_t left;
        NumberedTransitions::Row row;  ///< of its state

        void advance(std::size_t count) {
            phrases += count;
            history += count;
            left -= count;
        }
    };
    static Place place_of(Walk const& walk);
    static void move_to(Place const& place, Walk& walk);
    static bool step(NumberedTransitions::Reader const& transitions, Place& place, std::size_t ahead);
    static Place* take_turns(NumberedTransitions::Reader const& transitions, Place* first, Place* end,
                             std::size_t rounds);
    std::size_t walk_on(NumberedTransitions::Reader const& known);
    bool find_out(Walk& walk);
    void count_up(Walk& walk);
    static void find_regular_part(Walk& walk);
    static void find_numbered_part(Walk& walk);
    bool is_frozen(unsigned member) const;
    void charge_parking(Group const& group, RelativeState& real);
    Cycles cycles(Session const& session, Number number) const;
    TransitionStore::Range<Stand> stands(Session const& session, Number number) const;
    /// Visits transitions that are no sequences, from the last to the first, with the cycle at their end.
    template <class Visit> void go_back(Session const& session, Visit visit) const;
    void restore_stands(RelativeState& real);
    void extend(Trail& trail) const;
    void add_iterations(Group const& group, Session& session) const;
    void keep_history(RelativeState const& real, std::vector<std::uint64_t> const& iterations_before);
    static void forget_history(Session& session);
    static void keep_loose(Session& session);
    using Iterations = std::array<std::uint64_t, Transition::most_members>;  ///< by member
    Iterations iterations_since_entry(Session const& session, std::uint32_t members) const;
    StateView state_of(Session const& session) const;
    void keep_words(Session& session) const;

    Phrase phrase_;
    TransitionBench::Task task_;
    Session* session_ = nullptr;  ///< at hand
    bool decided_ = false;
    bool usable_ = false;
    bool driver_is_regular_ = false;
    bool in_steps_ = false;
    bool leaves_trails_ = false;
    std::unique_ptr<TransitionBench> bench_;

    StateTable states_{NumberedTransitions::numbers - 1};  ///< the last number stands for those without
    TransitionStore store_;
    Transition worked_on_;
    HashTable<Slot> table_{256};
    NumberedTransitions numbered_;  ///< by number of the phrase in a book
    NumberedTransitions pieces_;    ///< the same of pieces of phrases
    std::vector<Place> places_;
    std::vector<Number> sequence_;
    CutTrial cut_trial_;
    Slot once_;  ///< the last that was not worth remembering
    StatePage page_;
    std::uint64_t phrases_ = 0;
    std::uint64_t worked_out_ = 0;
    std::uint64_t worked_out_before_ = 0;  ///< the trial at hand
    std::uint64_t next_trial_ = 0;
};

/// One following of a group: from where it stood to where it stopped. And what is to be entered in its counters.
struct Automaton::Session {
    Number state = none;
    StateWords words;  ///< of the state, if it has no number
    Cycles begin = 0;
    Cycles time = 0;
    std::uint32_t frozen = 0;
    History history;                ///< of transitions; in a walk, room for all
    std::vector<Transition> loose;  ///< not worth remembering; numbers from first_loose on
    struct Entry {
        std::int64_t since;
        std::int64_t arrival;
        unsigned port;
    };
    std::vector<Entry> entry;               ///< where each follower stood, in absolute cycles
    std::vector<Transition::Stand> waited;  ///< and what it had waited for
    std::vector<std::vector<Cycles>> rooms;
    std::uint32_t entered = 0;  ///< members that entered a loop, a bit each
    // Iterations of a supplier that takes from memory: those that it had to do and was sure to find at the begin, those
    // done while logs are followed, and the cycles of all done.
    std::uint64_t fed_before = 0;
    std::uint64_t fed = 0;
    std::vector<Cycles> fed_cycles;

    /// The loop that a member is in since a session, of whose iterations states tell few: they are summed up when
    /// somebody asks, mostly never.
    struct OpenLoop {
        bool is_open = false;
        std::size_t from = 0;       ///< in kept_history
        std::uint64_t besides = 0;  ///< iterations before the first session, and between sessions
        std::uint64_t told = 0;     ///< by the last session's state
        std::uint64_t entries = 0;  ///< of loops, when the last session stopped
    };
    std::array<OpenLoop, Transition::most_members> open_loops{};
    History kept_history;  ///< of sessions since the first open loop was entered, about
    struct Loose {
        std::array<std::uint64_t, Transition::most_members> iterations;
        std::uint32_t entered;
    };
    std::vector<Loose> kept_loose;    ///< in kept_history, as far as loops are concerned
    std::vector<std::uint32_t> uses;  ///< of each transition, in all sessions
};

/// States without a number hardly come again. The driver alone gets out of them, unless it would stop inside an
/// iteration.
inline bool Automaton::is_worthwhile() const { return session_->state != none || !driver_is_regular_; }
inline bool Automaton::is_frozen(unsigned member) const { return ((session_->frozen >> member) & 1U) != 0; }

}  // namespace dataflow::timing
