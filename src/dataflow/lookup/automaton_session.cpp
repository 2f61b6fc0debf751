#include "dataflow/base/each_bit.hpp"
#include "dataflow/lookup/automaton.hpp"

// Sessions of an automaton: where they begin, where they end, and what they leave in the counters of a core.

namespace dataflow::timing {

namespace {
constexpr std::size_t longest_history = std::size_t{1} << 16;

/// What transitions add to the figures of a group.
class Figures {
  public:
    explicit Figures(RelativeState& real) : real_(real), totals_(real.blocks()) {}

    /// Of one, done `uses` times.
    template <class Blocks> void add(Blocks const& blocks, std::uint64_t uses) {
        for (FigureBlock const& block : blocks) {
            FigureTotal& total = totals_[block.number];
            for (std::size_t i = 0; i < total.sums.size(); ++i)
                total.sums[i] += uses * block.sums[i];
            total.largest = std::max<std::uint64_t>(total.largest, block.largest);
        }
    }
    void enter() { real_.enter(totals_); }

  private:
    RelativeState& real_;
    FigureTotals totals_;
};
}  // namespace

Cycles Automaton::cycles(Session const& session, Number number) const {
    return number < first_loose ? store_.brief(number).cycles() : session.loose[number - first_loose].cycles;
}

TransitionStore::Range<Transition::Stand> Automaton::stands(Session const& session, Number number) const {
    if (number < first_loose)
        return store_.stands(number);
    std::vector<Stand> const& loose = session.loose[number - first_loose].stands;
    return {loose.data(), loose.data() + loose.size()};
}

void Automaton::settle(Group const& group, Session& session) const {
    RelativeState real(group);
    Figures figures(real);
    for (std::size_t i = session.uses.size(); i > 0; --i) {  // sequences come after their pieces
        auto const number = static_cast<Number>(i - 1);
        if (session.uses[number] == 0)
            continue;
        if (store_.is_sequence(number)) {
            for (Number const piece : store_.pieces(number))
                session.uses[piece] += session.uses[number];
            continue;
        }
        figures.add(store_.figures(number), session.uses[number]);
    }
    figures.enter();
    session.uses.clear();
    add_iterations(group, session);
}

/// Tells the processes how often the loops they are in have been iterated in all sessions.
void Automaton::add_iterations(Group const& group, Session& session) const {
    RelativeState real(group);
    std::uint32_t open = 0;
    for (unsigned m = 0; m < group.members().size(); ++m) {
        Session::OpenLoop& loop = session.open_loops[m];
        bool const goes_on = loop.is_open && real.is_in_loop(m) && real.entries(m) == loop.entries;
        open |= goes_on ? 1U << m : 0U;
        loop.is_open = false;
    }
    Iterations const since_entry = iterations_since_entry(session, open);
    for_each_bit(open, [&](unsigned m) {
        Session::OpenLoop const& loop = session.open_loops[m];
        real.set_iterations(m, real.iterations(m) - loop.told + loop.besides + since_entry[m]);
    });
    session.kept_history.clear();
}

/// Of a mask of members, each back to where it entered its loop, if it did so in a session.
Automaton::Iterations Automaton::iterations_since_entry(Session const& session, std::uint32_t members) const {
    Iterations sums{};
    for (std::size_t i = session.kept_history.size(); i > 0 && members != 0; --i) {
        Number const number = session.kept_history[i - 1];
        auto const add = [&](auto const& tally) {
            for_each_bit(members, [&](unsigned m) {
                if (i <= session.open_loops[m].from)
                    members &= ~(1U << m);
                else
                    sums[m] += tally.iterations[m];
            });
            members &= ~std::uint32_t{tally.entered};
        };
        if (number < first_loose)
            add(store_.tally(number));
        else
            add(session.kept_loose[number - first_loose]);
    }
    return sums;
}

/// After a session, of which `iterations_before` are from its begin.
void Automaton::keep_history(RelativeState const& real, std::vector<std::uint64_t> const& iterations_before) {
    Session& session = *session_;
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
    }
    forget_history(session);
    keep_loose(session);
    if (session.kept_history.empty())
        session.kept_history.swap(session.history);
    else
        session.kept_history.insert(session.kept_history.end(), session.history.begin(), session.history.end());
}

/// What is needed of the loose transitions of a session, which get other numbers.
void Automaton::keep_loose(Session& session) {
    if (session.kept_history.empty())
        session.kept_loose.clear();
    auto const before = static_cast<Number>(session.kept_loose.size());
    for (Transition const& loose : session.loose)
        session.kept_loose.push_back({loose.iterations, loose.entered});
    if (before > 0 && !session.loose.empty())
        for (Number& number : session.history)
            number += number < first_loose ? 0 : before;
}

/// From before all loops that are open were entered.
void Automaton::forget_history(Session& session) {
    std::size_t first = session.kept_history.size();
    for (Session::OpenLoop const& loop : session.open_loops)
        first = loop.is_open ? std::min(first, loop.from) : first;
    if (first == 0)
        return;
    session.kept_history.erase(session.kept_history.begin(),
                               session.kept_history.begin() + static_cast<std::ptrdiff_t>(first));
    for (Session::OpenLoop& loop : session.open_loops)
        loop.from -= loop.is_open ? first : 0;
}

/// Where each follower goes on. False if one goes on with what no phrase can say.
bool Automaton::find_outlooks(Group const& group, Script const* script, RelativeState& real) {
    session_->frozen = going_on_elsewhere(group);
    for (unsigned m = 1; m < group.members().size(); ++m) {
        Group::Member const& member = group.members()[m];
        bool const frozen = is_frozen(m);
        if (frozen && !member.writes_anchor)
            return false;
        bool const as_scripted = script != nullptr && !member.writes_anchor;
        real.outlooks()[m] = {as_scripted ? script->next_ports[m] : Phrase::next_of(member, 0).ports, frozen};
    }
    return true;
}

/// Brings the group's state to the bench. False if it is one that no phrase can start from.
bool Automaton::begin(Group const& group, Script const* script) {
    RelativeState real(group);
    session_->history.clear();
    session_->entered = 0;
    session_->entry.clear();
    session_->waited.clear();
    session_->rooms.assign(group.fifos().size(), {});
    session_->fed_cycles.clear();
    if (!find_outlooks(group, script, real))
        return false;
    for (unsigned f = 0; f < group.fifos().size(); ++f)
        if (is_frozen(group.fifos()[f].writer))
            session_->rooms[f] = real.room_times(f);
    // The logs stay where they are: the state of a follower at rest has none. Where a script goes on, what is left of
    // them belongs to the state.
    std::uint32_t const logs = script == nullptr ? 0 : group.readers();
    if (!real.save(page_, logs))
        return false;
    real.clear_logs(logs);
    session_->begin = session_->time = group.driver().local_time();
    bench_->go_to(page_.words());
    std::vector<TransitionBench::Waiting> const waitings = bench_->park(worked_on_.figures, session_->waited);
    for (unsigned m = 1; m < group.members().size(); ++m) {
        TransitionBench::Waiting const& waiting = waitings[m - 1];
        Cycles const own = group.members()[m].process->local_time();
        auto const since =
            is_frozen(m) ? static_cast<std::int64_t>(own) : waiting.since + static_cast<std::int64_t>(session_->time);
        session_->entry.push_back(
            {since, static_cast<std::int64_t>(group.members()[m].process->waiting_since()), waiting.port});
    }
    charge_parking(group, real);
    keep_words(*session_);
    session_->state = number_of_state();
    session_->loose.clear();
    return true;
}

void Automaton::charge_parking(Group const& group, RelativeState& real) {
    Figures figures(real);
    figures.add(worked_on_.figures, 1);
    figures.enter();
    for (TrailEvent const& event : bench_->take_trail())
        group.driver().trail()->append(event, session_->begin);
}

/// Writes the state in which the session stopped, and all it counted, back to the group.
void Automaton::end(Group const& group, Script* script) {
    RelativeState real(group);
    Figures figures(real);
    for (Transition const& loose : session_->loose)
        figures.add(loose.figures, 1);
    figures.enter();
    std::vector<std::uint64_t> iterations_before;
    for (unsigned m = 0; m < group.members().size(); ++m)
        iterations_before.push_back(real.iterations(m));
    real.restore(state_of(*session_), session_->time);
    if (script != nullptr)
        for (unsigned m = 1; m < group.members().size(); ++m)
            script->next_ports[m] = real.outlooks()[m].next_ports;
    restore_stands(real);
    if (group.fed() != 0)
        group.members()[group.supplier()].process->take_fed(session_->fed_cycles);
    if (group.driver().trail() != nullptr)
        extend(*group.driver().trail());
    keep_history(real, iterations_before);
    if (session_->kept_history.size() > longest_history)
        add_iterations(group, *session_);
    for (unsigned f = 0; f < group.fifos().size(); ++f) {
        std::vector<Cycles> const& times = session_->rooms[f];
        std::size_t const known = group.fifos()[f].fifo->known_writes();
        if (!is_frozen(group.fifos()[f].writer))
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

/// Until a visit says that it is enough.
template <class Visit> void Automaton::go_back(Session const& session, Visit visit) const {
    Cycles time = session.time;
    bool goes_on = true;
    for (std::size_t i = session.history.size(); i > 0 && goes_on; --i) {
        Number const number = session.history[i - 1];
        auto const pieces = number < first_loose ? store_.pieces(number) : TransitionStore::only(number);
        for (Number const* piece = pieces.end(); piece != pieces.begin() && goes_on; --piece) {
            goes_on = visit(piece[-1], time);
            time -= cycles(session, piece[-1]);
        }
    }
}

/// A follower's own time is that of the last transition that moved it; it only waited since.
void Automaton::restore_stands(RelativeState& real) {
    std::vector<Session::Entry> found = session_->entry;
    std::vector<std::vector<RelativeState::EarlierWait>> waits(found.size());
    std::uint32_t missing_since = (1U << (found.size() + 1)) - 2;
    std::uint32_t missing_arrival = missing_since;
    auto const take = [&](Stand const& stand, Cycles time) {
        std::uint32_t const bit = 1U << stand.member;
        Session::Entry& entry = found[stand.member - 1U];
        auto const since = stand.since + static_cast<std::int64_t>(time);
        if (stand.is_over) {
            if ((missing_arrival & bit) != 0)
                waits[stand.member - 1U].push_back({static_cast<unsigned>(stand.port), static_cast<Cycles>(since)});
            return;
        }
        if ((missing_since & bit) != 0) {
            entry.since = since;
            entry.port = static_cast<unsigned>(stand.port);
        }
        missing_since &= ~bit;
        if (stand.arrived && (missing_arrival & bit) != 0)
            entry.arrival = stand.arrival + static_cast<std::int64_t>(time);
        if (stand.arrived)
            missing_arrival &= ~bit;
    };
    go_back(*session_, [&](Number number, Cycles time) {
        auto const all = stands(*session_, number);
        for (Stand const* stand = all.end(); stand != all.begin(); --stand)
            take(stand[-1], time);
        return missing_arrival != 0;
    });
    for (std::size_t i = session_->waited.size(); i > 0; --i)
        take(session_->waited[i - 1], session_->begin);
    for (unsigned m = 1; m <= found.size(); ++m) {
        Session::Entry const& entry = found[m - 1];
        real.unpark(m, entry.port, static_cast<Cycles>(entry.arrival), static_cast<Cycles>(entry.since), waits[m - 1]);
    }
}

}  // namespace dataflow::timing
