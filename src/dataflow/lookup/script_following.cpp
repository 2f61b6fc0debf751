#include <algorithm>

#include "dataflow/lookup/automaton.hpp"

namespace dataflow::timing {

namespace {
constexpr std::size_t most_left_over = 8;  // operations that a follower may be behind
constexpr std::size_t most_loose = 4096;   // transitions in one walk

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
    if (supplier.fed_ports != 0)
        return supplier.fed_iterations();
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

bool Automaton::set_out(Walk& walk) {
    session_ = walk.session;
    walk.begin = walk.counted = walk.script->next;
    find_regular_part(walk);
    find_numbered_part(walk);
    if (walk.begin == walk.end || is_far_apart(*walk.group) || !begin(*walk.group, walk.script))
        return false;
    if (!is_worthwhile()) {
        walk.end = walk.begin;
        walk.due_behind = walk.script->due;
    }
    session_->history.resize(static_cast<std::size_t>(walk.end - walk.begin));
    return true;
}

/// The phrases for which the supplier goes on as it does, and has more to do; or has written enough, if it takes no
/// part.
void Automaton::find_regular_part(Walk& walk) {
    Script const& script = *walk.script;
    walk.end = script.end;
    walk.due_behind = 0;
    if (!walk.group->has_supplier())
        return;
    Group::Member const& supplier = walk.group->members()[walk.group->supplier()];
    std::uint64_t const left =
        goes_on_elsewhere(supplier) ? supplies_at_hand(supplier) + 1 : regular_supplies(supplier);
    if (left > script.due)
        return;
    // From the end, as the supplier mostly has enough for nearly all.
    while (walk.end != script.next && script.due - walk.due_behind >= left)
        walk.due_behind += (*script.book)[*--walk.end].due;
}

Automaton::Place Automaton::place_of(Walk const& walk) {
    auto const done = walk.script->next - walk.begin;
    return {walk.script->next, walk.session->history.data() + done,
            static_cast<std::size_t>(walk.end - walk.script->next), NumberedTransitions::row_of(walk.session->state)};
}

void Automaton::move_to(Place const& place, Walk& walk) {
    walk.script->next = walk.end - place.left;
    walk.session->state = NumberedTransitions::state_of(place.row);
}

std::size_t Automaton::go_on(std::vector<Walk*> const& walks) {
    places_.clear();
    for (Walk const* const walk : walks)
        places_.push_back(place_of(*walk));
    std::size_t stopped = 0;
    for (;;) {
        stopped = walk_on(NumberedTransitions::Reader(numbered_));
        move_to(places_[stopped], *walks[stopped]);
        if (!find_out(*walks[stopped]))
            break;
        places_[stopped] = place_of(*walks[stopped]);
    }
    for (std::size_t i = 0; i < walks.size(); ++i)
        move_to(places_[i], *walks[i]);
    return stopped;
}

/// The phrases before one whose number is too large for the table of transitions.
void Automaton::find_numbered_part(Walk& walk) {
    PhraseBook const& book = *walk.script->book;
    if (book.size() <= NumberedTransitions::numbers)
        return;
    auto const is_too_large = [](PhraseBook::Number number) { return number >= NumberedTransitions::numbers; };
    PhraseBook::Number const* const end = std::find_if(walk.begin, walk.end, is_too_large);
    while (walk.end != end)
        walk.due_behind += book[*--walk.end].due;
}

/// By the transition so many phrases ahead; the place's pointers stay. False if it is not known.
inline bool Automaton::step(NumberedTransitions::Reader const& transitions, Place& place, std::size_t ahead) {
    Number const number = transitions.move(place.row, place.phrases[ahead]);
    if (number == NumberedTransitions::Known::none)
        return false;
    place.history[ahead] = number;
    return true;
}

/// So many rounds, unless a place has to stop: which, or the end.
inline Automaton::Place* Automaton::take_turns(NumberedTransitions::Reader const& transitions, Place* first, Place* end,
                                               std::size_t rounds) {
    auto const advance = [](Place* from, Place* to, std::size_t done) {
        for (; from != to; ++from)
            from->advance(done);
    };
    for (std::size_t round = 0; round < rounds; ++round)
        for (Place* place = first; place != end; ++place)
            if (!step(transitions, *place, round)) {
                advance(first, place, round + 1);
                advance(place, end, round);
                return place;
            }
    advance(first, end, rounds);
    return end;
}

/// All places in turns, as many rounds at a time as none of them comes to its end. Where one had to stop. Never
/// inlined: where it shares registers with others, look-ups take a tenth longer.
[[gnu::noinline]] std::size_t Automaton::walk_on(NumberedTransitions::Reader const& transitions) {
    auto const is_shorter = [](Place const& one, Place const& other) { return one.left < other.left; };
    Place* const first = places_.data();
    Place* const end = first + places_.size();
    for (;;) {
        Place* const shortest = std::min_element(first, end, is_shorter);
        if (shortest->left == 0)
            return static_cast<std::size_t>(shortest - first);
        if (places_.size() == 1) {
            Place alone = *first;  // in registers
            take_turns(transitions, &alone, &alone + 1, alone.left);
            *first = alone;
            return 0;
        }
        Place* const stopped = take_turns(transitions, first, end, shortest->left);
        if (stopped != end)
            return static_cast<std::size_t>(stopped - first);
    }
}

/// All known transitions that a walk has taken since the last time.
void Automaton::count_up(Walk& walk) {
    Session& session = *walk.session;
    Number const* const from = session.history.data() + (walk.counted - walk.begin);
    Number const* const to = session.history.data() + (walk.script->next - walk.begin);
    make_room_for_uses(session);
    std::uint32_t* const uses = session.uses.data();
    Cycles time = session.time;
    std::uint32_t entered = session.entered;
    for (Number const* number = from; number != to; ++number) {
        TransitionStore::Brief const brief = store_.brief(*number);
        ++uses[*number];
        if (brief.notable())
            note(session, *number, time);
        time += brief.cycles();
        entered |= brief.entered();
    }
    session.time = time;
    session.entered = entered;
    phrases_ += static_cast<std::uint64_t>(to - from);
    walk.counted = walk.script->next;
}

bool Automaton::find_out(Walk& walk) {
    Script& script = *walk.script;
    if (script.next == walk.end || walk.session->loose.size() >= most_loose)
        return false;
    session_ = walk.session;
    count_up(walk);
    Number const from = session_->state;
    Slot slot;
    if (!put_together(walk, slot) && !(take_up(walk, *script.next) && work_out(slot)))
        return false;
    if (slot.number < first_loose)
        numbered_.add(from, *script.next, {slot.next, slot.number});
    session_->history[static_cast<std::size_t>(script.next++ - walk.begin)] = slot.number;
    apply(slot);
    walk.counted = script.next;
    return true;
}

/// The phrase with that number is the one to be worked out; false: it cannot be.
bool Automaton::take_up(Walk const& walk, PhraseBook::Number number) {
    PhraseBook const& book = *walk.script->book;
    Group const& group = *walk.group;
    PhraseBook::Entry const& entry = book[number];
    task_ = {book.codes(number), entry.size, entry.active, 0};
    if (entry.due > 0 && !is_frozen(group.supplier())) {
        if (entry.due > Operation::longest_mix)
            return false;
        task_.supplies = entry.due;
        task_.active |= 1U << group.supplier();
    }
    return true;
}

/// The transition by the next phrase, from those by its pieces. False if that cannot be done, or what decides their
/// times is asked for, of which transitions tell as a whole.
bool Automaton::put_together(Walk const& walk, Slot& slot) {
    PhraseBook const& book = *walk.script->book;
    PhraseBook::Number const number = *walk.script->next;
    std::uint32_t const count = book[number].pieces;
    if (count == 0 || session_->state == none || leaves_trails_ || !cut_trial_.decide())
        return false;
    sequence_.clear();
    slot.next = session_->state;
    for (PhraseBook::Number const* piece = book.pieces(number); piece != book.pieces(number) + count; ++piece) {
        NumberedTransitions::Known known = NumberedTransitions::Reader(pieces_).find(slot.next, *piece);
        if (!known)
            known = work_out_piece(walk, slot.next, *piece);
        if (!known)
            return false;
        auto const pieces = store_.pieces(known.number);
        sequence_.insert(sequence_.end(), pieces.begin(), pieces.end());
        slot.next = known.next;
    }
    if (!store_.accepts_sequence(sequence_))
        return false;
    slot.number = store_.add_sequence(sequence_);
    describe(slot);
    return true;
}

/// False if it cannot be done, or is not worth remembering.
NumberedTransitions::Known Automaton::work_out_piece(Walk const& walk, Number state, PhraseBook::Number piece) {
    if (!take_up(walk, piece))
        return {};
    cut_trial_.worked_out_piece();
    if (!perform(states_[state]) || !store_.accepts(worked_on_))
        return {};
    Number const next = number_of_state();
    if (next == none)
        return {};
    NumberedTransitions::Known const known = {next, store_.add(worked_on_)};
    pieces_.add(state, piece, known);
    return known;
}

bool Automaton::arrive(Walk& walk) {
    Script& script = *walk.script;
    Group const& group = *walk.group;
    session_ = walk.session;
    count_up(walk);
    session_->history.resize(static_cast<std::size_t>(script.next - walk.begin));
    std::uint64_t due = walk.due_behind;
    for (auto number = script.next; number != walk.end; ++number)
        due += (*script.book)[*number].due;
    if (group.has_supplier() && group.fed() == 0 && due != script.due && !is_frozen(group.supplier()))
        group.members()[group.supplier()].process->log().consume(0, static_cast<std::uint32_t>(script.due - due));
    script.due = due;
    end(group, &script);
    return script.next != walk.begin;
}

}  // namespace dataflow::timing
