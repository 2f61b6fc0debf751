#include "timing/automaton.hpp"

namespace faster::timing {

namespace {
constexpr std::size_t most_left_over = 8;  // operations that a follower may be behind

bool can_be_left_over(Operation const& operation, Group::Member const& member) {
    bool const foreign = (operation.all_ports() & ~member.inner_ports) != 0;
    return !foreign && operation.kind() != Operation::Kind::stamp && operation.kind() != Operation::Kind::flanked;
}

/// Iterations at the front of a supplier's log that only write its anchor, as it will do again after them.
std::uint64_t regular_supplies(Group::Member const& supplier) {
    OperationLog const& log = supplier.process->log();
    if (log.exhausted())
        return 0;
    Operation const& front = log.front();
    bool const is_regular = front.kind() == Operation::Kind::iterate && front.ports() == 1U << supplier.anchor_port &&
                            front.gap() == 0 && front.tail_ports() == 0;
    return is_regular ? front.count() : 0;
}
}  // namespace

bool Automaton::is_where_script_goes_on(Group const& group) {
    if (!group.driver().finished())
        return false;
    for (unsigned m = 1; m < group.members().size(); ++m) {
        Group::Member const& member = group.members()[m];
        OperationLog const& log = member.process->log();
        if (member.writes_anchor)
            continue;
        if (log.pending() > most_left_over)
            return false;
        for (std::size_t i = 0; i < log.pending(); ++i)
            if (!can_be_left_over(log.begin()[i], member))
                return false;
    }
    return true;
}

void Automaton::write_next(Group const& group, Script& script) {
    PhraseBook::Number const number = *script.next++;
    PhraseBook::Entry const& entry = (*script.book)[number];
    script.due -= entry.due;
    Phrase::write(
        script.book->codes(number), entry.size, group,
        [&script](unsigned member, std::uint8_t next_ports, bool) { script.next_ports[member] = next_ports; });
}

bool Automaton::follow_script(Group const& group, Session& session, Script& script) {
    session_ = &session;
    if (!begin(group, &script))
        return false;
    bool const is_worthwhile = session.state != none || !driver_is_regular_;
    session.history.reserve(static_cast<std::size_t>(script.end - script.next));
    PhraseBook::Number const* const first = script.next;
    RegularPart const part = is_worthwhile ? regular_part(group, script) : RegularPart{first, script.due};
    while (script.next != part.end && follow_known(group, script, part.end)) {
    }
    std::uint64_t due = part.due_behind;
    for (auto number = script.next; number != part.end; ++number)
        due += (*script.book)[*number].due;
    if (group.has_supplier() && due != script.due && !is_frozen(group.supplier()))
        group.members()[group.supplier()].process->log().consume(0, static_cast<std::uint32_t>(script.due - due));
    script.due = due;
    end(group, &script);
    return script.next != first;
}

/// The phrases for which the supplier goes on as it does, and has more to do.
Automaton::RegularPart Automaton::regular_part(Group const& group, Script const& script) const {
    RegularPart part{script.end, 0};
    if (!group.has_supplier() || is_frozen(group.supplier()))
        return part;
    std::uint64_t const left = regular_supplies(group.members()[group.supplier()]);
    while (part.end != script.next && part.due_behind + left <= script.due)
        part.due_behind += (*script.book)[*--part.end].due;
    return part;
}

/// As far as transitions are known, and one more. False if that could not be worked out.
bool Automaton::follow_known(Group const& group, Script& script, PhraseBook::Number const* limit) {
    Session& session = *session_;
    session.uses.resize(store_.size());
    PhraseBook::Number const* next = script.next;
    Number state = session.state;
    Cycles time = session.time;
    std::uint32_t entered = session.entered;
    while (next != limit && state != none) {
        NumberedTransitions::Slot const* const known = numbered_.find(state, *next);
        if (known == nullptr)
            break;
        TransitionStore::Brief const brief = store_.brief(known->number);
        ++session.uses[known->number];
        session.history.push_back(known->number);
        time += brief.cycles;
        entered |= brief.entered;
        state = known->next;
        ++next;
        if (brief.notable) {
            session.time = time;
            note(store_.notes(known->number).froze, store_.notes(known->number).rooms);
        }
    }
    phrases_ += static_cast<std::uint64_t>(next - script.next);
    session.time = time;
    session.entered = entered;
    session.state = state;
    script.next = next;
    return next == limit || follow_new(group, script);
}

bool Automaton::follow_new(Group const& group, Script& script) {
    PhraseBook::Number const number = *script.next;
    PhraseBook::Entry const& entry = (*script.book)[number];
    phrase_.assign(script.book->codes(number), entry.size, entry.active);
    if (entry.due > 0 && !is_frozen(group.supplier())) {
        if (entry.due > Operation::longest_mix)
            return false;
        Group::Member const& supplier = group.members()[group.supplier()];
        phrase_.add_part(static_cast<std::uint8_t>(1U << supplier.anchor_port), entry.due, group.supplier());
    }
    Number const from = session_->state;
    Slot slot;
    if (!work_out(slot))
        return false;
    if (slot.number < first_loose)
        numbered_.add(from, number, slot.next, slot.number);
    ++script.next;
    apply(slot);
    return true;
}

}  // namespace faster::timing
