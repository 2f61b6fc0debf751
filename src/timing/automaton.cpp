#include "timing/automaton.hpp"

#include <algorithm>

#include "timing/core_timing.hpp"

namespace faster::timing {

namespace {
constexpr Cycles bench_time = Cycles{1} << 40;  // times before it stay positive
constexpr std::int64_t longest_reach = 4096;    // states with times further apart hardly ever come again
constexpr std::uint64_t most_room = 1024;       // tokens in FIFOs that a state may have to list
constexpr std::size_t most_transitions = 1U << 18;
constexpr std::uint64_t trial = 20000;  // phrases, before giving up a core that rarely repeats itself

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 29);
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
            if (loop.depth < loop.interval.achieved || (&member != &group.members().front() && !is_regular(loop)))
                return false;
    return true;
}
}  // namespace

Automaton::Automaton() = default;
Automaton::~Automaton() = default;

std::size_t Automaton::WordsHash::operator()(Words const& words) const {
    std::uint64_t hash = words.size();
    for (std::int64_t word : words)
        hash = mixed(hash, static_cast<std::uint64_t>(word));
    return hash;
}

bool Automaton::fits(CoreTiming const& core, Lead const& lead, Group const& group) {
    if (!decided_) {
        decided_ = true;
        usable_ = can_follow(group);
        bench_core_ = core.blank_copy();
        bench_group_ = std::make_unique<Group>(*bench_core_, lead);
        bench_ = std::make_unique<RelativeState>(*bench_group_);
        forget_all();
    }
    if (phrases_ > trial && worked_out_ * 4 > phrases_)
        usable_ = false;
    return usable_;
}

Automaton::Progress Automaton::follow(Group const& group) {
    Progress progress;
    std::uint32_t const frozen = 0;
    if (phrase_.read(group, frozen) == Phrase::Reading::logs_end)
        return {false, true};
    if (!begin(group))
        return progress;
    Phrase::Reading reading = phrase_.read(group, session_.frozen);
    for (; reading == Phrase::Reading::complete; reading = phrase_.read(group, session_.frozen)) {
        std::uint64_t const hash = hash_of_phrase();
        Transition* transition = session_.state == unnumbered ? nullptr : find(hash);
        if (transition == nullptr)
            transition = work_out(hash);
        if (transition == nullptr)
            break;
        phrase_.consume();
        apply(*transition);
    }
    progress.moved = !session_.history.empty();
    progress.later = reading == Phrase::Reading::logs_end;
    end(group);
    return progress;
}

void Automaton::apply(Transition& transition) {
    ++phrases_;
    session_.time += transition.cycles;
    session_.state = transition.next;
    session_.history.push_back(&transition);
    if (transition.uses++ == 0)
        session_.used.push_back(&transition);
    for (std::uint32_t mask = transition.entered; mask != 0; mask &= mask - 1)
        session_.entered[static_cast<unsigned>(__builtin_ctz(mask))] = session_.history.size();
    session_.frozen |= transition.froze;
    for (Room const& room : transition.rooms) {
        std::vector<Cycles>& times = session_.rooms[room.fifo];
        if (room.all)
            times.clear();
        for (std::int64_t from : room.from)
            times.push_back(session_.time + static_cast<Cycles>(from));
    }
}

/// Brings the group's state to the bench. False if it is one that no phrase can start from.
bool Automaton::begin(Group const& group) {
    if (transitions_.size() > most_transitions)
        forget_all();
    RelativeState real(group);
    session_.frozen = 0;
    session_.entry.clear();
    session_.iterations.assign(1, real.iterations(0));
    session_.rooms.assign(group.fifos().size(), {});
    for (unsigned m = 1; m < group.members().size(); ++m) {
        Phrase::Next const next = Phrase::next_of(group.members()[m], 0);
        bool const frozen = next.known && next.ports == 0;
        if (frozen && !group.members()[m].writes_anchor)
            return false;
        real.outlooks()[m] = {next.ports, frozen};
        session_.frozen |= frozen ? 1U << m : 0U;
        session_.iterations.push_back(real.iterations(m));
    }
    for (unsigned f = 0; f < group.fifos().size(); ++f)
        if (((session_.frozen >> group.fifos()[f].writer) & 1U) != 0)
            session_.rooms[f] = real.room_times(f);
    // The logs stay where they are: the state of a follower at rest has none.
    if (!real.save(words_, false))
        return false;
    session_.time = group.driver().local_time();
    bench_->load(words_, bench_time);
    std::vector<std::uint64_t*> const bench_counters = bench_->counters();
    std::vector<std::uint64_t> before;
    for (std::uint64_t const* counter : bench_counters)
        before.push_back(*counter);
    for (unsigned m = 1; m < group.members().size(); ++m) {
        RelativeState::Waiting const waiting = bench_->park(m);
        Cycles const shift = session_.time - bench_time;
        Cycles const own = group.members()[m].process->local_time();
        bool const frozen = ((session_.frozen >> m) & 1U) != 0;
        session_.entry.push_back({m, static_cast<std::int64_t>(frozen ? own : waiting.since + shift),
                                  static_cast<std::int64_t>(group.members()[m].process->waiting_since()), true});
    }
    std::vector<std::uint64_t*> const counters = real.counters();
    for (std::size_t i = 0; i < counters.size(); ++i)
        *counters[i] += *bench_counters[i] - before[i];
    bench_->save(session_.words, true);
    session_.state = bench_->reach() > longest_reach ? unnumbered : number_of(session_.words);
    session_.history.clear();
    session_.used.clear();
    session_.loose.clear();
    session_.entered.assign(group.members().size(), 0);
    return true;
}

/// Writes the state in which the session stopped, and all it counted, back to the group.
void Automaton::end(Group const& group) {
    RelativeState real(group);
    std::vector<std::uint64_t*> const counters = real.counters();
    for (Transition const* transition : session_.used)
        for (Growth const& growth : transition->growth)
            *counters[growth.counter] += transition->uses * growth.amount;
    real.restore(session_.state == unnumbered ? session_.words : *states_[session_.state], session_.time);
    restore_stands(real);
    restore_iterations(real);
    for (unsigned f = 0; f < group.fifos().size(); ++f) {
        std::vector<Cycles> const& times = session_.rooms[f];
        std::size_t const known = group.fifos()[f].fifo->known_writes();
        if (((session_.frozen >> group.fifos()[f].writer) & 1U) == 0)
            continue;
        for (std::size_t i = 0; i < known; ++i)
            real.set_room_time(f, i, times[times.size() - known + i]);
    }
    for (Transition* transition : session_.used)
        transition->uses = 0;
}

/// A follower's own time is that of the last transition that moved it; it only waited since.
void Automaton::restore_stands(RelativeState& real) {
    std::vector<Stand> found = session_.entry;
    std::uint32_t missing_since = (1U << (found.size() + 1)) - 2;
    std::uint32_t missing_arrival = missing_since;
    Cycles time = session_.time;
    for (std::size_t i = session_.history.size(); i > 0 && missing_arrival != 0; --i) {
        Transition const& transition = *session_.history[i - 1];
        for (Stand const& stand : transition.stands) {
            std::uint32_t const bit = 1U << stand.member;
            if ((missing_since & bit) != 0)
                found[stand.member - 1].since = stand.since + static_cast<std::int64_t>(time);
            missing_since &= ~bit;
            if (stand.arrived && (missing_arrival & bit) != 0)
                found[stand.member - 1].arrival = stand.arrival + static_cast<std::int64_t>(time);
            if (stand.arrived)
                missing_arrival &= ~bit;
        }
        time -= transition.cycles;
    }
    for (Stand const& stand : found)
        real.unpark(stand.member, static_cast<Cycles>(stand.arrival), static_cast<Cycles>(stand.since));
}

/// Iterations of the loop entry at hand: from the last transition that entered one.
void Automaton::restore_iterations(RelativeState& real) {
    std::vector<Transition*> const& history = session_.history;
    for (unsigned m = 0; m < session_.iterations.size(); ++m) {
        std::size_t const entered = session_.entered[m];
        std::uint64_t sum = 0;
        if (entered * 2 > history.size()) {
            for (std::size_t i = entered - 1; i < history.size(); ++i)
                sum += history[i]->iterations[m];
        } else {
            for (Transition const* transition : session_.used)
                sum += transition->uses * transition->iterations[m];
            for (std::size_t i = 0; i + 1 < entered; ++i)
                sum -= history[i]->iterations[m];
        }
        real.set_iterations(m, sum + (entered == 0 ? session_.iterations[m] : 0));
    }
}

std::uint64_t Automaton::hash_of_phrase() const {
    std::uint64_t hash = session_.state;
    for (unsigned i = 0; i < phrase_.size(); ++i)
        hash = mixed(hash, phrase_.codes()[i]);
    return hash;
}

Automaton::Transition* Automaton::find(std::uint64_t hash) const {
    std::size_t const mask = table_.size() - 1;
    for (std::size_t i = hash & mask; table_[i].transition != nullptr; i = (i + 1) & mask) {
        if (table_[i].hash != hash)
            continue;
        std::vector<Phrase::Code> const& key = table_[i].transition->key;
        if (key.size() == phrase_.size() + 1 && key.front() == session_.state &&
            std::equal(key.begin() + 1, key.end(), phrase_.codes()))
            return table_[i].transition;
    }
    return nullptr;
}

/// Performs the phrase on the bench, operation by operation. Null if the driver cannot finish it.
Automaton::Transition* Automaton::work_out(std::uint64_t hash) {
    ++worked_out_;
    bench_->load(session_.state == unnumbered ? session_.words : *states_[session_.state], bench_time);
    std::vector<std::uint64_t> before;
    for (std::uint64_t const* counter : bench_->counters())
        before.push_back(*counter);
    std::vector<Cycles> loaded;
    for (Group::Member const& member : bench_group_->members())
        loaded.push_back(member.process->local_time());
    Transition transition;
    Phrase::write(phrase_.codes(), phrase_.size(), *bench_group_,
                  [&](unsigned member, std::uint8_t next_ports, bool frozen) {
                      transition.froze |= frozen ? 1U << member : 0U;
                      bench_->outlooks()[member] = {next_ports, frozen};
                  });
    transition.entered = Phrase::entered(phrase_.codes(), phrase_.size());
    for (unsigned m = 0; m < loaded.size(); ++m)
        transition.iterations.push_back(bench_->iterations(m));
    bench_core_->resolve();
    if (!bench_group_->driver().finished())
        return nullptr;
    for (unsigned m = 0; m < loaded.size(); ++m) {
        bool const entered = ((transition.entered >> m) & 1U) != 0;
        transition.iterations[m] = bench_->iterations(m) - (entered ? 0 : transition.iterations[m]);
    }
    describe(before, loaded, transition);
    bool const recurring = bench_->reach() <= longest_reach;
    session_.words = words_;
    transition.next = recurring ? number_of(words_) : unnumbered;
    if (!recurring || session_.state == unnumbered)
        return &session_.loose.emplace_back(std::move(transition));
    transition.key.push_back(session_.state);
    transition.key.insert(transition.key.end(), phrase_.codes(), phrase_.codes() + phrase_.size());
    transitions_.push_back(std::move(transition));
    put_into_table({hash, &transitions_.back()});
    return &transitions_.back();
}

void Automaton::describe(std::vector<std::uint64_t> const& before, std::vector<Cycles> const& loaded,
                         Transition& transition) {
    transition.cycles = bench_group_->driver().local_time() - bench_time;
    describe_rooms(transition);
    describe_stands(loaded, transition);
    bench_->save(words_, true);
    std::vector<std::uint64_t*> const after = bench_->counters();
    for (std::uint32_t i = 0; i < after.size(); ++i)
        if (*after[i] != before[i])
            transition.growth.push_back({i, *after[i] - before[i]});
}

void Automaton::describe_stands(std::vector<Cycles> const& loaded, Transition& transition) {
    Cycles const end = bench_group_->driver().local_time();
    auto const since_end = [end](Cycles cycle) { return static_cast<std::int64_t>(cycle - end); };
    for (unsigned m = 1; m < loaded.size(); ++m) {
        bool const active = ((phrase_.active() >> m) & 1U) != 0;
        bool const frozen = bench_->outlooks()[m].frozen;
        if (frozen && !active)
            continue;
        RelativeState::Waiting const waiting = bench_->park(m);
        if (active || waiting.since != loaded[m])
            transition.stands.push_back({m, since_end(waiting.since), since_end(waiting.arrival), active});
    }
}

/// All a frozen writer needs to know later, which its state does not say.
void Automaton::describe_rooms(Transition& transition) {
    Cycles const end = bench_group_->driver().local_time();
    for (unsigned f = 0; f < bench_group_->fifos().size(); ++f) {
        Group::Inner const& inner = bench_group_->fifos()[f];
        if (!bench_->outlooks()[inner.writer].frozen)
            continue;
        bool const froze = ((transition.froze >> inner.writer) & 1U) != 0;
        std::vector<Cycles> const times = bench_->room_times(f);
        std::size_t const fresh = froze ? times.size() : std::min(times.size(), RelativeState::loaded_reads(inner));
        Room room{f, froze, {}};
        for (std::size_t i = times.size() - fresh; i < times.size(); ++i)
            room.from.push_back(static_cast<std::int64_t>(times[i] - end));
        if (froze || fresh > 0)
            transition.rooms.push_back(std::move(room));
    }
}

std::uint32_t Automaton::number_of(Words const& words) {
    auto const [place, is_new] = numbers_.try_emplace(words, static_cast<std::uint32_t>(states_.size()));
    if (is_new)
        states_.push_back(&place->first);
    return place->second;
}

void Automaton::put_into_table(Slot const& slot) {
    if (transitions_.size() * 2 > table_.size()) {
        std::vector<Slot> old(table_.size() * 2);
        old.swap(table_);
        for (Slot const& each : old)
            if (each.transition != nullptr && each.transition != slot.transition)
                put_into_table(each);
    }
    std::size_t const mask = table_.size() - 1;
    std::size_t i = slot.hash & mask;
    while (table_[i].transition != nullptr)
        i = (i + 1) & mask;
    table_[i] = slot;
}

void Automaton::forget_all() {
    numbers_.clear();
    states_.clear();
    transitions_.clear();
    table_.assign(1U << 14, Slot{});
}

}  // namespace faster::timing
