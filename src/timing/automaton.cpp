#include "timing/automaton.hpp"

#include <algorithm>

#include "timing/core_timing.hpp"

namespace faster::timing {

namespace {
constexpr Cycles longest_reach = 4096;  // states with times further apart hardly ever come again
constexpr std::size_t longest_history = std::size_t{1} << 16;
constexpr std::uint64_t most_room = 1024;  // tokens in FIFOs that a state may have to list
// If of so many phrases more than one in so many is new, the core repeats itself too rarely to be remembered.
constexpr std::uint64_t trial = 1U << 17;
constexpr std::uint64_t one_in = 4;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 29);
}

/// A loop that reads and writes carries setups along, which no state tells.
bool is_known(LoopShape const& loop) {
    return loop.reads.empty() && ProcessTiming::iterations_that_count(loop) <= RelativeState::most_iterations;
}

bool is_regular(LoopShape const& loop) {
    for (LoopWrite const& write : loop.writes)
        if (write.write_latency != loop.writes.front().write_latency)
            return false;
    return true;
}

bool can_follow(Group const& group) {
    std::uint64_t room = 0;
    for (Group::Inner const& inner : group.fifos())
        room += inner.fifo->shape().capacity + inner.fifo->shape().issue_latency;
    if (room > most_room)
        return false;
    for (Group::Member const& member : group.members())
        for (LoopShape const& loop : member.process->loops())
            if (!is_known(loop) || (&member != &group.members().front() && !is_regular(loop)))
                return false;
    return true;
}
}  // namespace

Automaton::Automaton() = default;
Automaton::~Automaton() = default;

std::size_t Automaton::WordsHash::operator()(Words const& words) const {
    std::uint64_t hashes[2] = {words.size(), 0};  // two, for neither has to wait for the other
    std::size_t i = 0;
    for (; i + 1 < words.size(); i += 2) {
        hashes[0] = mixed(hashes[0], static_cast<std::uint64_t>(words[i]));
        hashes[1] = mixed(hashes[1], static_cast<std::uint64_t>(words[i + 1]));
    }
    if (i < words.size())
        hashes[0] = mixed(hashes[0], static_cast<std::uint64_t>(words[i]));
    return mixed(hashes[0], hashes[1]);
}

bool Automaton::fits(CoreTiming const& core, Lead const& lead, Group const& group) {
    if (!decided_) {
        decided_ = true;
        next_trial_ = trial;
        usable_ = can_follow(group);
        auto const& loops = group.driver().loops();
        driver_is_regular_ = std::all_of(loops.begin(), loops.end(), is_regular);
        bench_ = std::make_unique<TransitionBench>(core, lead, leaves_trails_);
    }
    if (phrases_ >= next_trial_) {
        usable_ = usable_ && (worked_out_ - worked_out_before_) * one_in <= trial;
        worked_out_before_ = worked_out_;
        next_trial_ = phrases_ + trial;
    }
    return usable_;
}

/// Times far apart hardly come again. The driver alone gets out of that, unless it would stop inside an iteration. Seen
/// at a glance, where a follower is ahead; else begin() will tell.
bool Automaton::is_far_apart(Group const& group) const {
    Cycles const end = group.driver().local_time() + longest_reach;
    auto const is_ahead = [end](Group::Member const& member) {
        return member.process->local_time() > end && Phrase::next_of(member, 0).ports != 0;
    };
    return driver_is_regular_ && std::any_of(group.members().begin() + 1, group.members().end(), is_ahead);
}

Automaton::Progress Automaton::follow(Group const& group, Session& session, Script const* script) {
    Progress progress;
    session_ = &session;
    phrase_.set_log_ends(script == nullptr ? nullptr : script->next_ports.data());
    if (phrase_.read(group, 0) == Phrase::Reading::logs_end)
        return {false, true};
    if (is_far_apart(group) || !begin(group))
        return progress;
    bool const is_worthwhile = session.state != none || !driver_is_regular_;
    Phrase::Reading reading = is_worthwhile ? phrase_.read(group, session.frozen) : Phrase::Reading::foreign;
    for (; reading == Phrase::Reading::complete; reading = phrase_.read(group, session.frozen)) {
        Print const print = print_of_phrase();
        Slot const* slot = session.state == none ? nullptr : table_.find(print);
        if (slot == nullptr)
            slot = work_out(print);
        if (slot == nullptr)
            break;
        phrase_.consume();
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
        note(session, loose.froze, loose.rooms);
        return;
    }
    session.time += slot.cycles;
    session.entered |= slot.entered;
    if (slot.number >= session.uses.size())
        session.uses.resize(store_.size());
    ++session.uses[slot.number];
    if (slot.notable)
        note(session, store_.notes(slot.number).froze, store_.notes(slot.number).rooms);
}

void Automaton::note(Session& session, std::uint32_t froze, std::vector<Room> const& rooms) {
    session.frozen |= froze;
    for (Room const& room : rooms) {
        std::vector<Cycles>& times = session.rooms[room.fifo];
        if (room.all)
            times.clear();
        for (std::int64_t from : room.from)
            times.push_back(session.time + static_cast<Cycles>(from));
    }
}

Cycles Automaton::cycles(Session const& session, Number number) const {
    return number < first_loose ? store_.brief(number).cycles : session.loose[number - first_loose].cycles;
}

TransitionStore::Range<Transition::Stand> Automaton::stands(Session const& session, Number number) const {
    if (number < first_loose)
        return store_.stands(number);
    std::vector<Stand> const& loose = session.loose[number - first_loose].stands;
    return {loose.data(), loose.data() + loose.size()};
}

void Automaton::settle(Group const& group, Session& session) const {
    RelativeState real(group);
    std::vector<std::uint64_t*> const counters = real.counters();
    for (std::size_t i = 0; i < session.uses.size(); ++i) {
        if (session.uses[i] == 0)
            continue;
        auto const number = static_cast<Number>(i);
        for (Growth const& growth : store_.growth(number))
            *counters[growth.counter] += session.uses[i] * growth.amount;
        for (Transition::Peak const& peak : store_.peaks(number))
            real.raise_peak(peak.fifo, peak.occupancy);
    }
    session.uses.clear();
    add_iterations(group, session);
}

/// Tells the processes how often the loops they are in have been iterated in all sessions.
void Automaton::add_iterations(Group const& group, Session& session) const {
    RelativeState real(group);
    for (unsigned m = 0; m < group.members().size(); ++m) {
        Session::OpenLoop& loop = session.open_loops[m];
        if (loop.is_open && real.is_in_loop(m) && real.entries(m) == loop.entries)
            real.set_iterations(m, real.iterations(m) - loop.told + loop.besides + iterations_since_entry(session, m));
        loop.is_open = false;
    }
    session.kept_history.clear();
}

/// Back to where the member entered its loop, if it did so in a session.
std::uint64_t Automaton::iterations_since_entry(Session const& session, unsigned member) const {
    std::uint64_t sum = 0;
    bool entered = false;
    auto const add = [&](auto const& tally) {
        sum += tally.iterations[member];
        entered = ((tally.entered >> member) & 1U) != 0;
    };
    for (std::size_t i = session.kept_history.size(); i > session.open_loops[member].from && !entered; --i) {
        Number const number = session.kept_history[i - 1];
        if (number < first_loose)
            add(store_.tally(number));
        else
            add(session.loose[number - first_loose]);
    }
    return sum;
}

/// After a session, of which `iterations_before` are from its begin.
void Automaton::keep_history(RelativeState const& real, std::vector<std::uint64_t> const& iterations_before) {
    Session& session = *session_;
    bool any_open = false;
    for (unsigned m = 0; m < iterations_before.size(); ++m) {
        Session::OpenLoop& loop = session.open_loops[m];
        bool const entered = ((session.entered >> m) & 1U) != 0;
        bool const goes_on = loop.is_open && loop.entries == real.entries(m) && !entered;
        if (goes_on) {
            loop.besides += iterations_before[m] - loop.told;
        } else {
            loop.from = session.kept_history.size();
            loop.besides = entered ? 0 : iterations_before[m];
        }
        loop.is_open = real.is_in_loop(m);
        loop.told = real.iterations(m);
        loop.entries = real.entries(m);
        any_open = any_open || loop.is_open;
    }
    if (any_open)
        session.kept_history.insert(session.kept_history.end(), session.history.begin(), session.history.end());
    else
        session.kept_history.clear();
}

/// Where each follower goes on. False if one goes on with what no phrase can say.
bool Automaton::find_outlooks(Group const& group, Script const* script, RelativeState& real) {
    for (unsigned m = 1; m < group.members().size(); ++m) {
        Group::Member const& member = group.members()[m];
        Phrase::Next const next = Phrase::next_of(member, 0);
        bool const frozen = next.known && next.ports == 0;
        if (frozen && !member.writes_anchor)
            return false;
        bool const as_scripted = script != nullptr && !member.writes_anchor;
        real.outlooks()[m] = {as_scripted ? script->next_ports[m] : next.ports, frozen};
        session_->frozen |= frozen ? 1U << m : 0U;
    }
    return true;
}

/// Brings the group's state to the bench. False if it is one that no phrase can start from.
bool Automaton::begin(Group const& group, Script const* script) {
    RelativeState real(group);
    session_->history.clear();
    session_->entered = 0;
    session_->frozen = 0;
    session_->entry.clear();
    session_->rooms.assign(group.fifos().size(), {});
    if (!find_outlooks(group, script, real))
        return false;
    for (unsigned f = 0; f < group.fifos().size(); ++f)
        if (((session_->frozen >> group.fifos()[f].writer) & 1U) != 0)
            session_->rooms[f] = real.room_times(f);
    // The logs stay where they are: the state of a follower at rest has none. Where a script goes on, what is left of
    // them belongs to the state.
    std::uint32_t const logs = script == nullptr ? 0 : group.readers();
    if (!real.save(words_, logs))
        return false;
    real.clear_logs(logs);
    session_->begin = session_->time = group.driver().local_time();
    std::vector<RelativeState::Waiting> const waitings = bench_->park(words_);
    for (unsigned m = 1; m < group.members().size(); ++m) {
        RelativeState::Waiting const& waiting = waitings[m - 1];
        Cycles const shift = session_->time - bench_->time();
        Cycles const own = group.members()[m].process->local_time();
        bool const frozen = ((session_->frozen >> m) & 1U) != 0;
        session_->entry.push_back({m, static_cast<std::int64_t>(frozen ? own : waiting.since + shift),
                                   static_cast<std::int64_t>(group.members()[m].process->waiting_since()), waiting.port,
                                   true});
    }
    charge_parking(group, real);
    session_->words = bench_->words();
    session_->state = bench_->reach() > static_cast<std::int64_t>(longest_reach) ? none : number_of(session_->words);
    session_->loose.clear();
    return true;
}

void Automaton::charge_parking(Group const& group, RelativeState const& real) {
    std::vector<std::uint64_t*> const counters = real.counters();
    for (Growth const& growth : bench_->parking_growth())
        *counters[growth.counter] += growth.amount;
    for (TrailEvent const& event : bench_->take_trail())
        group.driver().trail()->append(event, session_->begin);
}

/// Writes the state in which the session stopped, and all it counted, back to the group.
void Automaton::end(Group const& group, Script* script) {
    RelativeState real(group);
    std::vector<std::uint64_t*> const counters = real.counters();
    for (Transition const& loose : session_->loose) {
        for (Growth const& growth : loose.growth)
            *counters[growth.counter] += growth.amount;
        for (Transition::Peak const& peak : loose.peaks)
            real.raise_peak(peak.fifo, peak.occupancy);
    }
    std::vector<std::uint64_t> iterations_before;
    for (unsigned m = 0; m < group.members().size(); ++m)
        iterations_before.push_back(real.iterations(m));
    real.restore(session_->state == none ? session_->words : *states_[session_->state], session_->time);
    if (script != nullptr)
        for (unsigned m = 1; m < group.members().size(); ++m)
            script->next_ports[m] = real.outlooks()[m].next_ports;
    restore_stands(real);
    if (group.driver().trail() != nullptr)
        extend(*group.driver().trail());
    keep_history(real, iterations_before);
    if (!session_->loose.empty() || session_->kept_history.size() > longest_history)
        add_iterations(group, *session_);
    for (unsigned f = 0; f < group.fifos().size(); ++f) {
        std::vector<Cycles> const& times = session_->rooms[f];
        std::size_t const known = group.fifos()[f].fifo->known_writes();
        if (((session_->frozen >> group.fifos()[f].writer) & 1U) == 0)
            continue;
        for (std::size_t i = 0; i < known; ++i)
            real.set_room_time(f, i, times[times.size() - known + i]);
    }
}

void Automaton::extend(Trail& trail) const {
    Cycles time = session_->begin;
    bool goes_on = false;
    for (Number const number : session_->history) {
        bool const remembered = number < first_loose;
        if (!remembered)
            for (TrailEvent const& event : session_->loose[number - first_loose].trail)
                trail.append(event, time);
        time += cycles(*session_, number);
        if (remembered)
            trail.followed(number, time, goes_on);
        goes_on = remembered;
    }
}

/// A follower's own time is that of the last transition that moved it; it only waited since.
void Automaton::restore_stands(RelativeState& real) {
    std::vector<Stand> found = session_->entry;
    std::uint32_t missing_since = (1U << (found.size() + 1)) - 2;
    std::uint32_t missing_arrival = missing_since;
    Cycles time = session_->time;
    for (std::size_t i = session_->history.size(); i > 0 && missing_arrival != 0; --i) {
        for (Stand const& stand : stands(*session_, session_->history[i - 1])) {
            std::uint32_t const bit = 1U << stand.member;
            if ((missing_since & bit) != 0) {
                found[stand.member - 1].since = stand.since + static_cast<std::int64_t>(time);
                found[stand.member - 1].port = stand.port;
            }
            missing_since &= ~bit;
            if (stand.arrived && (missing_arrival & bit) != 0)
                found[stand.member - 1].arrival = stand.arrival + static_cast<std::int64_t>(time);
            if (stand.arrived)
                missing_arrival &= ~bit;
        }
        time -= cycles(*session_, session_->history[i - 1]);
    }
    for (Stand const& stand : found)
        real.unpark(stand.member, stand.port, static_cast<Cycles>(stand.arrival), static_cast<Cycles>(stand.since));
}

/// Two codes at a time go into a product of 128 bits, with what came before.
Automaton::Print Automaton::print_of_phrase() const {
    __extension__ using Wide = unsigned __int128;
    std::uint64_t first = (session_->state + std::uint64_t{1}) * 0x9E3779B97F4A7C15U;
    std::uint64_t second = 0xC2B2AE3D27D4EB4FU + phrase_.size();
    auto const take = [&first, &second](std::uint64_t one, std::uint64_t other) {
        Wide const product = Wide{one ^ first} * (other ^ second);
        std::uint64_t const turned = (first << 32) | (first >> 32);
        first = static_cast<std::uint64_t>(product) + second;
        second = static_cast<std::uint64_t>(product >> 64) ^ turned;
    };
    Phrase::Code const* const codes = phrase_.codes();
    unsigned i = 0;
    for (; i + 1 < phrase_.size(); i += 2)
        take(codes[i], codes[i + 1]);
    take(i < phrase_.size() ? codes[i] : 0, 0xD6E8FEB86659FD93U);
    return {first ^ (first >> 32), second};
}

/// Null if the driver cannot finish the phrase.
Automaton::Slot const* Automaton::work_out(Print const& print) {
    once_ = Slot();
    once_.print = print;
    if (!work_out(once_))
        return nullptr;
    return once_.number < first_loose ? table_.add(once_) : &once_;
}

/// Performs the phrase on the bench. False if the driver cannot finish it.
bool Automaton::work_out(Slot& slot) {
    ++worked_out_;
    worked_on_.clear();
    Words const& from = session_->state == none ? session_->words : *states_[session_->state];
    if (!bench_->work_out(from, phrase_, worked_on_))
        return false;
    bool const recurring = bench_->reach() <= static_cast<std::int64_t>(longest_reach);
    bool const remembered = recurring && session_->state != none && store_.accepts(worked_on_);
    slot.next = recurring ? number_of(bench_->words()) : none;
    if (slot.next == none)
        session_->words = bench_->words();
    slot.notable = TransitionStore::is_notable(worked_on_);
    if (!remembered) {
        slot.number = first_loose + static_cast<Number>(session_->loose.size());
        session_->loose.push_back(worked_on_);
        return true;
    }
    slot.number = store_.add(worked_on_);
    slot.cycles = store_.brief(slot.number).cycles;
    slot.entered = store_.brief(slot.number).entered;
    return true;
}

std::uint32_t Automaton::number_of(Words const& words) {
    auto const [place, is_new] = numbers_.try_emplace(words, static_cast<std::uint32_t>(states_.size()));
    if (is_new)
        states_.push_back(&place->first);
    return place->second;
}

}  // namespace faster::timing
