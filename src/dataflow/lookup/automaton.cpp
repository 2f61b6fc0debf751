#include "dataflow/lookup/automaton.hpp"

#include <algorithm>

#include "dataflow/core/time/core_timing.hpp"

namespace dataflow::timing {

namespace {
constexpr Cycles longest_reach = 4096;     // of times in states with a number
constexpr std::uint64_t most_room = 4096;  // tokens in FIFOs that a state may have to list
// If of so many phrases more than one in so many is new, the core repeats itself too rarely to be remembered. The first
// trial is short, as it shows then, and much is new anyway.
constexpr std::uint64_t first_trial = 1U << 15, trial = 1U << 17;
constexpr std::uint64_t one_in = 4, one_in_at_first = 2;

/// A loop that reads and writes is one of steps: see LoopsInSteps.
bool is_known(LoopShape const& loop, LoopPlan const& plan) {
    return (loop.reads.empty() || plan.aligned) && iterations_that_count(loop) <= ProcessFlags::most_begun;
}

/// Of all loops, none has a delay line.
bool is_regular(ProcessShape const& shape) {
    return std::all_of(shape.plans.begin(), shape.plans.end(), [](LoopPlan const& plan) { return plan.aligned; });
}

bool is_known(ProcessShape const& shape) {
    for (std::size_t i = 0; i < shape.loops.size(); ++i)
        if (!is_known(shape.loops[i], shape.plans[i]))
            return false;
    return true;
}

/// A flushing pipeline in the group has both its ends there.
bool can_flush(Group::Member const& member, Group const& group) {
    if (!member.process->flushes())
        return true;
    auto const all = static_cast<Ports::Number>((1U << member.process->port_count()) - 1U);
    return &member != &group.members().front() && member.process->port_count() == 2 && member.inner_ports == all;
}

/// No state of a process tells of its rests between calls.
bool rewinds(CoreTiming const& core) {
    return std::any_of(core.processes().begin(), core.processes().end(), [](ProcessTiming const& process) {
        return std::any_of(process.loops().begin(), process.loops().end(),
                           [](LoopShape const& loop) { return loop.rewinds; });
    });
}

bool can_follow(Group const& group) {
    std::uint64_t room = 0;
    for (Group::Inner const& inner : group.fifos())
        room += inner.fifo->shape().capacity + inner.fifo->shape().issue_latency;
    if (room > most_room || group.fifos().size() > TransitionBench::most_fifos || group.members().size() == 1)
        return false;
    for (Group::Member const& member : group.members()) {
        if (member.process->loops().size() > TransitionBench::most_loops || !can_flush(member, group))
            return false;
        std::shared_ptr<ProcessShape const> const shape = member.process->fed_shape();
        if (!is_known(*shape) || (&member != &group.members().front() && !is_regular(*shape)))
            return false;
    }
    return true;
}

}  // namespace

Automaton::Automaton() = default;
Automaton::~Automaton() = default;

bool Automaton::fits(CoreTiming const& core, Lead const& lead, Group const& group, bool in_steps) {
    if (!decided_) {
        decided_ = true;
        next_trial_ = first_trial;
        usable_ = can_follow(group) && !rewinds(core);
        driver_is_regular_ = is_regular(*group.driver().shape());
        in_steps_ = in_steps;
        if (usable_)
            bench_ = std::make_unique<TransitionBench>(core, lead, leaves_trails_);
    }
    if (phrases_ >= next_trial_) {
        bool const is_first = next_trial_ == first_trial;
        std::uint64_t const most_new = is_first ? first_trial / one_in_at_first : trial / one_in;
        usable_ = usable_ && worked_out_ - worked_out_before_ <= most_new;
        worked_out_before_ = worked_out_;
        next_trial_ = phrases_ + trial;
    }
    return usable_ && in_steps == in_steps_;
}

/// A cheap look before begin(): whether some follower is so far ahead of the driver that is_worthwhile() will say no.
bool Automaton::is_far_apart(Group const& group) const {
    Cycles const end = group.driver().local_time() + longest_reach;
    auto const is_ahead = [end](Group::Member const& member) {
        return member.process->local_time() > end && !goes_on_elsewhere(member);
    };
    return driver_is_regular_ && std::any_of(group.members().begin() + 1, group.members().end(), is_ahead);
}

/// Whether its next access is outside the group.
bool Automaton::goes_on_elsewhere(Group::Member const& member) {
    Phrase::Next const next = Phrase::next_of(member, 0);
    return next.known && next.ports == 0;
}

/// The members whose next access is outside the group, a bit each.
std::uint32_t Automaton::going_on_elsewhere(Group const& group) {
    std::uint32_t members = 0;
    for (unsigned m = 1; m < group.members().size(); ++m)
        members |= goes_on_elsewhere(group.members()[m]) ? 1U << m : 0U;
    return members;
}

/// The next phrase. Of a supplier that takes from memory it says nothing: what that has to do is
/// supplies_of_phrase(), and must be less than it is sure to find.
Phrase::Reading Automaton::read(Group const& group, std::uint32_t frozen) {
    Phrase::Reading const reading = phrase_.read(group, frozen | group.fed(), Phrase::most_in_run);
    std::uint64_t const supplies = supplies_of_phrase(group, frozen);
    if (reading != Phrase::Reading::complete || supplies == 0 || session_->fed + supplies < session_->fed_before)
        return reading;
    ProcessTiming const& supplier = *group.members()[group.supplier()].process;
    bool const has_said_all = supplier.log().pending() > 1;
    bool const has_more = session_->fed + supplies < supplier.alike_iterations();
    return has_said_all || has_more ? Phrase::Reading::foreign : Phrase::Reading::logs_end;
}

std::uint64_t Automaton::fed_iterations(Group const& group) {
    return group.fed() == 0 ? 0 : group.members()[group.supplier()].fed_iterations();
}

/// What the phrase asks of a supplier that takes from memory, and takes part.
std::uint32_t Automaton::supplies_of_phrase(Group const& group, std::uint32_t frozen) const {
    return (group.suppliers() & group.fed() & ~frozen) != 0 ? phrase_.due_of_supplier(group) : 0;
}

/// What the driver finds of a supplier that takes no part.
std::uint64_t Automaton::supplies_at_hand(Group::Member const& supplier) {
    return supplier.process->fifo(supplier.anchor_port).known_reads();
}

Automaton::Progress Automaton::follow(Group const& group, Session& session) {
    Progress progress;
    session_ = &session;
    session.fed = 0;
    session.fed_before = fed_iterations(group);
    Phrase::Reading reading = read(group, 0);
    if (reading == Phrase::Reading::logs_end)
        return {false, true};
    if (is_far_apart(group))
        return progress;
    std::uint32_t const elsewhere = going_on_elsewhere(group);
    if (elsewhere != 0)
        reading = read(group, elsewhere);
    progress.later = reading == Phrase::Reading::logs_end;
    // Within a phrase that asks for more the driver would stop.
    constexpr std::uint64_t no_limit = ~std::uint64_t{0};
    bool const takes_part = (group.suppliers() & elsewhere) == 0;
    std::uint64_t supplies = takes_part ? no_limit : supplies_at_hand(group.members()[group.supplier()]);
    if (reading != Phrase::Reading::complete || phrase_.due_of_supplier(group) > supplies || !begin(group))
        return progress;
    if (!is_worthwhile())
        reading = Phrase::Reading::foreign;
    for (; reading == Phrase::Reading::complete && phrase_.due_of_supplier(group) <= supplies;
         reading = read(group, session.frozen)) {
        Print const print = phrase_.print(session.state + std::uint64_t{1});
        Slot const* slot = session.state == none ? nullptr : find(print);
        if (slot == nullptr)
            slot = work_out(print, group);
        if (slot == nullptr)
            break;
        phrase_.consume();
        supplies -= phrase_.due_of_supplier(group);
        session.fed += supplies_of_phrase(group, session.frozen);
        session.history.push_back(slot->number);
        apply(*slot);
    }
    progress.moved = !session.history.empty();
    progress.later = reading == Phrase::Reading::logs_end;
    end(group);
    return progress;
}

void Automaton::apply(Slot const& slot) {
    Session& session = *session_;
    ++phrases_;
    session.state = slot.next;
    if (slot.number >= first_loose) {
        Transition const& loose = session.loose[slot.number - first_loose];
        session.time += loose.cycles;
        session.entered |= loose.entered;
        note(session, loose.notes, session.time);
        return;
    }
    if (slot.notable)
        note(session, slot.number, session.time);
    session.time += slot.cycles;
    session.entered |= slot.entered;
    make_room_for_uses(session);
    ++session.uses[slot.number];
}

/// Of all transitions so far.
void Automaton::make_room_for_uses(Session& session) const {
    if (session.uses.size() < store_.size())
        session.uses.resize(2 * store_.size());
}

/// Of a transition that is remembered, and notable.
void Automaton::note(Session& session, Number number, Cycles begin) const {
    for (Number const piece : store_.pieces(number)) {
        begin += store_.brief(piece).cycles();
        if (store_.brief(piece).notable())
            note(session, store_.notes(piece), begin);
    }
}

void Automaton::note(Session& session, Transition::Notes const& notes, Cycles end) {
    session.frozen |= notes.froze;
    for (Room const& room : notes.rooms) {
        std::vector<Cycles>& times = session.rooms[room.fifo];
        if (room.all)
            times.clear();
        for (std::int64_t from : room.from)
            times.push_back(end + static_cast<Cycles>(from));
    }
    for (std::int64_t const since_end : notes.fed)
        session.fed_cycles.push_back(end + static_cast<Cycles>(since_end));
}

/// Null if the driver cannot finish the phrase.
Automaton::Slot const* Automaton::work_out(Print const& print, Group const& group) {
    std::uint32_t const supplies = supplies_of_phrase(group, session_->frozen);
    if (supplies > Operation::longest_mix)
        return nullptr;
    once_ = Slot();
    once_.print = print;
    task_ = {phrase_.codes(), phrase_.size(), phrase_.active(), supplies};
    task_.active |= supplies > 0 ? 1U << group.supplier() : 0U;
    if (!work_out(once_))
        return nullptr;
    return once_.number < first_loose ? table_.add(once_) : &once_;
}

/// Performs the task on the bench. False if the driver cannot finish it.
bool Automaton::perform(StateView from) {
    ++worked_out_;
    worked_on_.clear();
    bench_->go_to(from);
    return bench_->work_out(task_, worked_on_);
}

/// Of the state at which the bench is. None if it hardly comes again, or there are too many.
Automaton::Number Automaton::number_of_state() { return is_recurring() ? states_.number_of(bench_->state()) : none; }

/// From where the session is.
bool Automaton::work_out(Slot& slot) {
    if (!perform(state_of(*session_)))
        return false;
    slot.next = number_of_state();
    if (slot.next == none)
        keep_words(*session_);
    if (slot.next == none || session_->state == none || !store_.accepts(worked_on_)) {
        slot.number = first_loose + static_cast<Number>(session_->loose.size());
        session_->loose.push_back(worked_on_);
        return true;
    }
    slot.number = store_.add(worked_on_);
    describe(slot);
    return true;
}

/// Of a transition that is remembered.
void Automaton::describe(Slot& slot) const {
    TransitionStore::Brief const brief = store_.brief(slot.number);
    slot.cycles = brief.cycles();
    slot.entered = static_cast<std::uint8_t>(brief.entered());
    slot.notable = brief.notable();
}

/// The state at which the bench is is likely to come again: times further apart hardly ever do.
bool Automaton::is_recurring() const { return bench_->reach() <= static_cast<std::int64_t>(longest_reach); }

StateView Automaton::state_of(Session const& session) const {
    return session.state == none ? StateView(session.words) : states_[session.state];
}

/// Those of the bench, which the next transition changes.
void Automaton::keep_words(Session& session) const {
    StateView const state = bench_->state();
    session.words.assign(state.words, state.words + state.size);
}

}  // namespace dataflow::timing
