#include "timing/automaton.hpp"

#include <algorithm>

#include "timing/core_timing.hpp"

namespace faster::timing {

namespace {
constexpr Cycles bench_time = Cycles{1} << 40;  // times before it stay positive
constexpr std::int64_t longest_reach = 4096;    // states with times further apart hardly ever come again
constexpr std::uint64_t most_room = 1024;       // tokens in FIFOs that a state may have to list
constexpr std::size_t most_transitions = 1U << 18;  // about 100 MB
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
        auto const& loops = group.driver().loops();
        driver_is_regular_ = std::all_of(loops.begin(), loops.end(), is_regular);
        bench_core_ = core.blank_copy();
        bench_group_ = std::make_unique<Group>(*bench_core_, lead);
        bench_ = std::make_unique<RelativeState>(*bench_group_);
    }
    if (phrases_ > trial && worked_out_ * 4 > phrases_)
        usable_ = false;
    return usable_;
}

Automaton::Progress Automaton::follow(Group const& group, Ledger& ledger) {
    Progress progress;
    if (phrase_.read(group, 0) == Phrase::Reading::logs_end)
        return {false, true};
    if (!begin(group))
        return progress;
    // Times far apart hardly come again. The driver alone gets out of that, unless it would stop inside an iteration.
    bool const is_worthwhile = session_.state != unnumbered || !driver_is_regular_;
    Phrase::Reading reading = is_worthwhile ? phrase_.read(group, session_.frozen) : Phrase::Reading::foreign;
    for (; reading == Phrase::Reading::complete; reading = phrase_.read(group, session_.frozen)) {
        std::uint64_t const hash = hash_of_phrase();
        std::uint32_t number = session_.state == unnumbered ? none : find(hash);
        if (number == none)
            number = work_out(hash);
        if (number == none)
            break;
        phrase_.consume();
        apply(number, ledger);
    }
    progress.moved = !session_.history.empty();
    progress.later = reading == Phrase::Reading::logs_end;
    end(group);
    return progress;
}

void Automaton::apply(std::uint32_t number, Ledger& ledger) {
    Transition const& taken = transition(number);
    ++phrases_;
    session_.time += taken.cycles;
    session_.state = taken.next;
    session_.history.push_back(number);
    for (unsigned m = 0; m < most_members; ++m)
        session_.iterations[m] += taken.iterations[m];
    if (number < first_loose) {
        if (number >= ledger.size())
            ledger.resize(transitions_.size());
        ++ledger[number];
    }
    if (!taken.plain)
        apply_account(taken, account(number));
}

void Automaton::apply_account(Transition const& taken, Account const& account) {
    for (std::uint32_t mask = account.entered; mask != 0; mask &= mask - 1) {
        auto const m = static_cast<unsigned>(__builtin_ctz(mask));
        session_.iterations[m] = taken.iterations[m];
    }
    session_.frozen |= account.froze;
    for (Room const& room : account.rooms) {
        std::vector<Cycles>& times = session_.rooms[room.fifo];
        if (room.all)
            times.clear();
        for (std::int64_t from : room.from)
            times.push_back(session_.time + static_cast<Cycles>(from));
    }
}

void Automaton::settle(Group const& group, Ledger& ledger) const {
    std::vector<std::uint64_t*> const counters = RelativeState(group).counters();
    for (std::size_t i = 0; i < ledger.size(); ++i)
        if (ledger[i] > 0)
            for (Growth const& growth : accounts_[i].growth)
                *counters[growth.counter] += ledger[i] * growth.amount;
    ledger.clear();
}

/// Brings the group's state to the bench. False if it is one that no phrase can start from.
bool Automaton::begin(Group const& group) {
    RelativeState real(group);
    session_.frozen = 0;
    session_.entry.clear();
    session_.iterations[0] = real.iterations(0);
    session_.rooms.assign(group.fifos().size(), {});
    for (unsigned m = 1; m < group.members().size(); ++m) {
        Phrase::Next const next = Phrase::next_of(group.members()[m], 0);
        bool const frozen = next.known && next.ports == 0;
        if (frozen && !group.members()[m].writes_anchor)
            return false;
        real.outlooks()[m] = {next.ports, frozen};
        session_.frozen |= frozen ? 1U << m : 0U;
        session_.iterations[m] = real.iterations(m);
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
    session_.loose.clear();
    session_.loose_accounts.clear();
    return true;
}

/// Writes the state in which the session stopped, and all it counted, back to the group.
void Automaton::end(Group const& group) {
    RelativeState real(group);
    std::vector<std::uint64_t*> const counters = real.counters();
    for (Account const& account : session_.loose_accounts)
        for (Growth const& growth : account.growth)
            *counters[growth.counter] += growth.amount;
    real.restore(session_.state == unnumbered ? session_.words : *states_[session_.state], session_.time);
    restore_stands(real);
    for (unsigned m = 0; m < group.members().size(); ++m)
        real.set_iterations(m, session_.iterations[m]);
    for (unsigned f = 0; f < group.fifos().size(); ++f) {
        std::vector<Cycles> const& times = session_.rooms[f];
        std::size_t const known = group.fifos()[f].fifo->known_writes();
        if (((session_.frozen >> group.fifos()[f].writer) & 1U) == 0)
            continue;
        for (std::size_t i = 0; i < known; ++i)
            real.set_room_time(f, i, times[times.size() - known + i]);
    }
}

/// A follower's own time is that of the last transition that moved it; it only waited since.
void Automaton::restore_stands(RelativeState& real) {
    std::vector<Stand> found = session_.entry;
    std::uint32_t missing_since = (1U << (found.size() + 1)) - 2;
    std::uint32_t missing_arrival = missing_since;
    Cycles time = session_.time;
    for (std::size_t i = session_.history.size(); i > 0 && missing_arrival != 0; --i) {
        std::uint32_t const number = session_.history[i - 1];
        for (Stand const& stand : account(number).stands) {
            std::uint32_t const bit = 1U << stand.member;
            if ((missing_since & bit) != 0)
                found[stand.member - 1].since = stand.since + static_cast<std::int64_t>(time);
            missing_since &= ~bit;
            if (stand.arrived && (missing_arrival & bit) != 0)
                found[stand.member - 1].arrival = stand.arrival + static_cast<std::int64_t>(time);
            if (stand.arrived)
                missing_arrival &= ~bit;
        }
        time -= transition(number).cycles;
    }
    for (Stand const& stand : found)
        real.unpark(stand.member, static_cast<Cycles>(stand.arrival), static_cast<Cycles>(stand.since));
}

std::uint64_t Automaton::hash_of_phrase() const {
    // A sum of products, so that the multiplications do not wait for each other.
    std::uint64_t hash = session_.state * 0x9E3779B97F4A7C15U;
    std::uint64_t factor = 0xD6E8FEB86659FD93U;
    for (unsigned i = 0; i < phrase_.size(); ++i) {
        std::uint64_t const code = phrase_.codes()[i];
        hash += (code ^ (code >> 32)) * factor;
        factor += 0xA0761D6478BD642EU;
    }
    return mixed(hash, 0);
}

bool Automaton::is_key_of(Transition const& transition) const {
    Phrase::Code const* const key = keys_.data() + transition.key;
    bool same = transition.key_size == phrase_.size() + 1 && key[0] == session_.state;
    for (unsigned k = 0; same && k < phrase_.size(); ++k)
        same = key[k + 1] == phrase_.codes()[k];
    return same;
}

std::uint32_t Automaton::find(std::uint64_t hash) const {
    std::size_t const mask = table_.size() - 1;
    auto const tag = static_cast<std::uint32_t>(hash >> 32);
    for (std::size_t i = hash & mask; table_[i].transition != 0; i = (i + 1) & mask)
        if (table_[i].tag == tag && is_key_of(transitions_[table_[i].transition - 1]))
            return table_[i].transition - 1;
    return none;
}

/// Performs the phrase on the bench, operation by operation. `none` if the driver cannot finish it.
std::uint32_t Automaton::work_out(std::uint64_t hash) {
    ++worked_out_;
    bench_->load(session_.state == unnumbered ? session_.words : *states_[session_.state], bench_time);
    std::vector<std::uint64_t> before;
    for (std::uint64_t const* counter : bench_->counters())
        before.push_back(*counter);
    std::vector<Cycles> loaded;
    for (Group::Member const& member : bench_group_->members())
        loaded.push_back(member.process->local_time());
    Transition transition;
    Account account;
    Phrase::write(phrase_.codes(), phrase_.size(), *bench_group_,
                  [&](unsigned member, std::uint8_t next_ports, bool frozen) {
                      account.froze |= frozen ? 1U << member : 0U;
                      bench_->outlooks()[member] = {next_ports, frozen};
                  });
    account.entered = Phrase::entered(phrase_.codes(), phrase_.size());
    for (unsigned m = 0; m < loaded.size(); ++m)
        transition.iterations[m] = static_cast<std::uint32_t>(bench_->iterations(m));
    bench_core_->resolve();
    if (!bench_group_->driver().finished())
        return none;
    for (unsigned m = 0; m < loaded.size(); ++m) {
        bool const entered = ((account.entered >> m) & 1U) != 0;
        transition.iterations[m] =
            static_cast<std::uint32_t>(bench_->iterations(m)) - (entered ? 0 : transition.iterations[m]);
    }
    transition.cycles = bench_group_->driver().local_time() - bench_time;
    describe(before, loaded, account);
    transition.plain = account.is_plain();
    bool const recurring = bench_->reach() <= longest_reach;
    session_.words = words_;
    transition.next = recurring ? number_of(words_) : unnumbered;
    if (recurring && session_.state != unnumbered && transitions_.size() < most_transitions)
        return remember(transition, std::move(account), hash);
    session_.loose_accounts.push_back(std::move(account));
    session_.loose.push_back(transition);
    return first_loose + static_cast<std::uint32_t>(session_.loose.size() - 1);
}

std::uint32_t Automaton::remember(Transition transition, Account&& account, std::uint64_t hash) {
    transition.key = static_cast<std::uint32_t>(keys_.size());
    transition.key_size = static_cast<std::uint16_t>(phrase_.size() + 1);
    keys_.push_back(session_.state);
    keys_.insert(keys_.end(), phrase_.codes(), phrase_.codes() + phrase_.size());
    transitions_.push_back(transition);
    accounts_.push_back(std::move(account));
    hashes_.push_back(hash);
    put_into_table(hash, static_cast<std::uint32_t>(transitions_.size()));
    return static_cast<std::uint32_t>(transitions_.size() - 1);
}

void Automaton::describe(std::vector<std::uint64_t> const& before, std::vector<Cycles> const& loaded,
                         Account& account) {
    describe_rooms(account);
    describe_stands(loaded, account);
    bench_->save(words_, true);
    bench_->count_tokens();
    std::vector<std::uint64_t*> const after = bench_->counters();
    for (std::uint32_t i = 0; i < after.size(); ++i)
        if (*after[i] != before[i])
            account.growth.push_back({i, *after[i] - before[i]});
}

void Automaton::describe_stands(std::vector<Cycles> const& loaded, Account& account) {
    Cycles const end = bench_group_->driver().local_time();
    auto const since_end = [end](Cycles cycle) { return static_cast<std::int64_t>(cycle - end); };
    for (unsigned m = 1; m < loaded.size(); ++m) {
        bool const active = ((phrase_.active() >> m) & 1U) != 0;
        bool const frozen = bench_->outlooks()[m].frozen;
        if (frozen && !active)
            continue;
        RelativeState::Waiting const waiting = bench_->park(m);
        if (active || waiting.since != loaded[m])
            account.stands.push_back({m, since_end(waiting.since), since_end(waiting.arrival), active});
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

void Automaton::put_into_table(std::uint64_t hash, std::uint32_t number) {
    if (transitions_.size() * 2 > table_.size()) {
        table_.assign(table_.size() * 2, Slot{});
        for (std::uint32_t i = 0; i + 1 < number; ++i)
            put_into_table(hashes_[i], i + 1);
    }
    std::size_t const mask = table_.size() - 1;
    std::size_t i = hash & mask;
    while (table_[i].transition != 0)
        i = (i + 1) & mask;
    table_[i] = {static_cast<std::uint32_t>(hash >> 32), number};
}

}  // namespace faster::timing
