#include "timing/automaton.hpp"

#include <algorithm>

#include "timing/core_timing.hpp"

namespace faster::timing {

namespace {
constexpr Cycles bench_time = Cycles{1} << 40;      // times before it stay positive
constexpr std::int64_t longest_reach = 4096;        // states with times further apart hardly ever come again
constexpr std::uint64_t most_room = 1024;           // tokens in FIFOs that a state may have to list
constexpr std::size_t most_transitions = 1U << 17;  // about 150 MB
constexpr Cycles longest_cycles = 0xFFFFFFFF;       // that fit a transition
// If of so many phrases more than one in so many is new, the core repeats itself too rarely to be remembered.
constexpr std::uint64_t trial = 1U << 17;
constexpr std::uint64_t one_in = 4;

std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15U;
    return hash ^ (hash >> 29);
}

/// A loop that reads and writes carries setups along, which no state tells.
bool is_known(LoopShape const& loop) { return loop.reads.empty() && loop.depth >= loop.interval.achieved; }

bool is_regular(LoopShape const& loop) {
    for (LoopWrite const& write : loop.writes)
        if (write.write_latency != loop.writes.front().write_latency)
            return false;
    return true;
}

std::vector<std::uint64_t> values_of(std::vector<std::uint64_t*> const& counters) {
    std::vector<std::uint64_t> values(counters.size());
    std::transform(counters.begin(), counters.end(), values.begin(), [](std::uint64_t const* value) { return *value; });
    return values;
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
    std::uint64_t hash = words.size();
    for (std::int64_t word : words)
        hash = mixed(hash, static_cast<std::uint64_t>(word));
    return hash;
}

bool Automaton::fits(CoreTiming const& core, Lead const& lead, Group const& group) {
    if (!decided_) {
        decided_ = true;
        next_trial_ = trial;
        usable_ = can_follow(group);
        auto const& loops = group.driver().loops();
        driver_is_regular_ = std::all_of(loops.begin(), loops.end(), is_regular);
        bench_core_ = core.blank_copy();
        if (leaves_trails_)
            bench_core_->leave_trail(Trail::any_length);
        bench_group_ = std::make_unique<Group>(*bench_core_, lead);
        bench_ = std::make_unique<RelativeState>(*bench_group_);
        bench_counters_ = bench_->counters();
    }
    if (phrases_ >= next_trial_) {
        usable_ = usable_ && (worked_out_ - worked_out_before_) * one_in <= trial;
        worked_out_before_ = worked_out_;
        next_trial_ = phrases_ + trial;
    }
    return usable_;
}

Automaton::Progress Automaton::follow(Group const& group, Session& session) {
    Progress progress;
    session_ = &session;
    if (phrase_.read(group, 0) == Phrase::Reading::logs_end)
        return {false, true};
    if (!begin(group))
        return progress;
    // Times far apart hardly come again. The driver alone gets out of that, unless it would stop inside an iteration.
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
    session.history.push_back(slot.number);
    if (slot.number >= first_loose) {
        Account const& loose = account(session, slot.number);
        session.time += loose.cycles;
        note(loose);
        return;
    }
    session.time += slot.cycles;
    if (slot.number >= session.uses.size())
        session.uses.resize(accounts_.size());
    ++session.uses[slot.number];
    if (slot.notable)
        note(accounts_[slot.number]);
}

void Automaton::note(Account const& account) {
    session_->frozen |= account.froze;
    for (Room const& room : account.rooms) {
        std::vector<Cycles>& times = session_->rooms[room.fifo];
        if (room.all)
            times.clear();
        for (std::int64_t from : room.from)
            times.push_back(session_->time + static_cast<Cycles>(from));
    }
}

Automaton::Account const& Automaton::account(Session const& session, Number number) const {
    return number < first_loose ? accounts_[number] : session.loose[number - first_loose];
}

void Automaton::settle(Group const& group, Session& session) const {
    std::vector<std::uint64_t*> const counters = RelativeState(group).counters();
    for (std::size_t i = 0; i < session.uses.size(); ++i)
        if (session.uses[i] > 0)
            for (Growth const& growth : accounts_[i].growth)
                *counters[growth.counter] += session.uses[i] * growth.amount;
    session.uses.clear();
    add_iterations(group, session);
}

/// Tells the processes how often the loops they are in since the last session have been iterated in it.
void Automaton::add_iterations(Group const& group, Session& session) const {
    RelativeState real(group);
    for (unsigned m = 0; m < session.entries.size(); ++m) {
        if (!real.is_in_loop(m) || real.entries(m) != session.entries[m])
            continue;
        std::uint64_t sum = 0;
        bool entered = false;
        for (std::size_t i = session.history.size(); i > 0 && !entered; --i) {
            Account const& each = account(session, session.history[i - 1]);
            sum += each.iterations[m];
            entered = ((each.entered >> m) & 1U) != 0;
        }
        std::uint64_t const total = sum + (entered ? 0 : session.iterations[m]);
        std::uint64_t const counted = std::min<std::uint64_t>(total, 1);  // all that a state says
        real.set_iterations(m, real.iterations(m) - counted + total);
    }
    session.entries.clear();
    session.history.clear();
}

/// Brings the group's state to the bench. False if it is one that no phrase can start from.
bool Automaton::begin(Group const& group) {
    add_iterations(group, *session_);
    RelativeState real(group);
    session_->frozen = 0;
    session_->entry.clear();
    session_->rooms.assign(group.fifos().size(), {});
    for (unsigned m = 1; m < group.members().size(); ++m) {
        Phrase::Next const next = Phrase::next_of(group.members()[m], 0);
        bool const frozen = next.known && next.ports == 0;
        if (frozen && !group.members()[m].writes_anchor)
            return false;
        real.outlooks()[m] = {next.ports, frozen};
        session_->frozen |= frozen ? 1U << m : 0U;
    }
    for (unsigned f = 0; f < group.fifos().size(); ++f)
        if (((session_->frozen >> group.fifos()[f].writer) & 1U) != 0)
            session_->rooms[f] = real.room_times(f);
    // The logs stay where they are: the state of a follower at rest has none.
    if (!real.save(words_, false))
        return false;
    session_->begin = session_->time = group.driver().local_time();
    bench_->load(words_, bench_time);
    std::vector<std::uint64_t> const before = values_of(bench_counters_);
    for (unsigned m = 1; m < group.members().size(); ++m) {
        RelativeState::Waiting const waiting = bench_->park(m);
        Cycles const shift = session_->time - bench_time;
        Cycles const own = group.members()[m].process->local_time();
        bool const frozen = ((session_->frozen >> m) & 1U) != 0;
        session_->entry.push_back({m, static_cast<std::int64_t>(frozen ? own : waiting.since + shift),
                                   static_cast<std::int64_t>(group.members()[m].process->waiting_since()), waiting.port,
                                   true});
    }
    std::vector<std::uint64_t*> const counters = real.counters();
    for (std::size_t i = 0; i < counters.size(); ++i)
        *counters[i] += *bench_counters_[i] - before[i];
    if (leaves_trails_)
        for (TrailEvent const& event : take_trail())
            group.driver().trail()->append(event, session_->begin);
    bench_->save(session_->words, true);
    session_->state = bench_->reach() > longest_reach ? none : number_of(session_->words);
    session_->loose.clear();
    return true;
}

/// Writes the state in which the session stopped, and all it counted, back to the group.
void Automaton::end(Group const& group) {
    RelativeState real(group);
    std::vector<std::uint64_t*> const counters = real.counters();
    for (Account const& account : session_->loose)
        for (Growth const& growth : account.growth)
            *counters[growth.counter] += growth.amount;
    session_->iterations.clear();
    session_->entries.clear();
    for (unsigned m = 0; m < group.members().size(); ++m)
        session_->iterations.push_back(real.iterations(m));
    real.restore(session_->state == none ? session_->words : *states_[session_->state], session_->time);
    restore_stands(real);
    if (group.driver().trail() != nullptr)
        extend(*group.driver().trail());
    for (unsigned m = 0; m < group.members().size(); ++m)
        session_->entries.push_back(real.entries(m));
    for (unsigned f = 0; f < group.fifos().size(); ++f) {
        std::vector<Cycles> const& times = session_->rooms[f];
        std::size_t const known = group.fifos()[f].fifo->known_writes();
        if (((session_->frozen >> group.fifos()[f].writer) & 1U) == 0)
            continue;
        for (std::size_t i = 0; i < known; ++i)
            real.set_room_time(f, i, times[times.size() - known + i]);
    }
}

/// What has been left on the bench since the last call.
std::vector<TrailEvent> Automaton::take_trail() {
    return leaves_trails_ ? bench_core_->take_trail(bench_time) : std::vector<TrailEvent>();
}

void Automaton::extend(Trail& trail) const {
    Cycles time = session_->begin;
    bool goes_on = false;
    for (Number const number : session_->history) {
        Account const& each = account(*session_, number);
        bool const remembered = number < first_loose;
        for (TrailEvent const& event : each.trail)
            if (!remembered)
                trail.append(event, time);
        time += each.cycles;
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
        Account const& account_of = account(*session_, session_->history[i - 1]);
        for (Stand const& stand : account_of.stands) {
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
        time -= account_of.cycles;
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

/// Performs the phrase on the bench, operation by operation. Null if the driver cannot finish it.
Automaton::Slot const* Automaton::work_out(Print const& print) {
    ++worked_out_;
    bench_->load(session_->state == none ? session_->words : *states_[session_->state], bench_time);
    Before before;
    before.counters = values_of(bench_counters_);
    Account account;
    for (unsigned m = 0; m < bench_group_->members().size(); ++m) {
        before.times.push_back(bench_group_->members()[m].process->local_time());
        before.ports.push_back(bench_->waited_for(m));
        account.iterations[m] = bench_->iterations(m);
    }
    Phrase::write(phrase_.codes(), phrase_.size(), *bench_group_,
                  [&](unsigned member, std::uint8_t next_ports, bool frozen) {
                      account.froze |= frozen ? 1U << member : 0U;
                      bench_->outlooks()[member] = {next_ports, frozen};
                  });
    account.entered = Phrase::entered(phrase_.codes(), phrase_.size());
    bench_core_->resolve();
    if (!bench_group_->driver().finished()) {
        take_trail();  // it came to nothing
        return nullptr;
    }
    for (unsigned m = 0; m < before.times.size(); ++m) {
        bool const entered = ((account.entered >> m) & 1U) != 0;
        account.iterations[m] = bench_->iterations(m) - (entered ? 0 : account.iterations[m]);
    }
    account.cycles = bench_group_->driver().local_time() - bench_time;
    describe(before, account);
    account.trail = take_trail();
    bool const recurring = bench_->reach() <= longest_reach;
    bool const remembered =
        recurring && session_->state != none && accounts_.size() < most_transitions && account.cycles <= longest_cycles;
    session_->words = words_;
    Number const next = recurring ? number_of(words_) : none;
    Slot slot;
    slot.print = print;
    slot.next = next;
    if (!remembered) {
        slot.number = first_loose + static_cast<Number>(session_->loose.size());
        session_->loose.push_back(std::move(account));
        once_ = slot;
        return &once_;
    }
    slot.number = static_cast<Number>(accounts_.size());
    slot.cycles = static_cast<std::uint32_t>(account.cycles);
    slot.notable = account.froze != 0 || !account.rooms.empty();
    accounts_.push_back(std::move(account));
    return table_.add(slot);
}

void Automaton::describe(Before const& before, Account& account) {
    describe_rooms(account);
    describe_stands(before, account);
    bench_->save(words_, true);
    bench_->count_tokens();
    for (std::uint32_t i = 0; i < bench_counters_.size(); ++i)
        if (*bench_counters_[i] != before.counters[i])
            account.growth.push_back({i, *bench_counters_[i] - before.counters[i]});
}

void Automaton::describe_stands(Before const& before, Account& account) {
    Cycles const end = bench_group_->driver().local_time();
    auto const since_end = [end](Cycles cycle) { return static_cast<std::int64_t>(cycle - end); };
    for (unsigned m = 1; m < before.times.size(); ++m) {
        bool const active = ((phrase_.active() >> m) & 1U) != 0;
        bool const frozen = bench_->outlooks()[m].frozen;
        if (frozen && !active)
            continue;
        RelativeState::Waiting const waiting = bench_->park(m);
        bool const waits_anew = waiting.waits && waiting.port != before.ports[m];
        if (active || waits_anew || waiting.since != before.times[m])
            account.stands.push_back({m, since_end(waiting.since), since_end(waiting.arrival), waiting.port, active});
    }
}

/// All a frozen writer needs to know later, which its state does not say.
void Automaton::describe_rooms(Account& account) {
    Cycles const end = bench_group_->driver().local_time();
    for (unsigned f = 0; f < bench_group_->fifos().size(); ++f) {
        Group::Inner const& inner = bench_group_->fifos()[f];
        if (!bench_->outlooks()[inner.writer].frozen)
            continue;
        bool const froze = ((account.froze >> inner.writer) & 1U) != 0;
        std::vector<Cycles> const times = bench_->room_times(f);
        std::size_t const fresh = froze ? times.size() : std::min(times.size(), RelativeState::loaded_reads(inner));
        Room room{f, froze, {}};
        for (std::size_t i = times.size() - fresh; i < times.size(); ++i)
            room.from.push_back(static_cast<std::int64_t>(times[i] - end));
        if (froze || fresh > 0)
            account.rooms.push_back(std::move(room));
    }
}

std::uint32_t Automaton::number_of(Words const& words) {
    auto const [place, is_new] = numbers_.try_emplace(words, static_cast<std::uint32_t>(states_.size()));
    if (is_new)
        states_.push_back(&place->first);
    return place->second;
}

}  // namespace faster::timing
