#include "dataflow/run/replay/path_sweep.hpp"

#include <algorithm>

#include "dataflow/base/integer_bits.hpp"

namespace dataflow::timing {

namespace {
using Kind = TrailEvent::Kind;
using Share = PathSums::Share;

/// What has decided so far when a token leaves a flushing pipeline by a port.
PathSweep::Position decided(CoreTiming const& core, unsigned process, unsigned port,
                            ProcessTiming::Flight const& flight) {
    if (!flight.is_room)
        return {process, flight.since};
    return {static_cast<unsigned>(core.other_end(core.processes()[process], port)), flight.since - 1};
}

/// Whatever happens from now on has its causes in what a process has done so far, or in a token or a gap of a FIFO.
std::vector<PathSweep::Position> live_positions(CoreTiming const& core) {
    std::vector<PathSweep::Position> live;
    for (ProcessTiming const& process : core.processes()) {
        live.push_back({process.index(), PathSweep::everything});
        for (ProcessTiming::Flight const& flight : process.flights())
            live.push_back(decided(core, process.index(), process.flushing_port(), flight));
        for (unsigned port = 0; port < process.port_count(); ++port) {
            FifoTiming const& fifo = process.fifo(port);
            Cycles const latency = fifo.shape().read_latency + fifo.shape().issue_latency;
            bool const flies = fifo.shape().flushing_stages > 0;
            for (std::uint64_t i = 0; process.writes(port) && i < fifo.known_reads(); ++i)
                live.push_back({process.index(), fifo.earliest_read(i) - latency, flies});
            for (std::uint64_t i = 0; !process.writes(port) && i < fifo.known_writes(); ++i)
                if (fifo.earliest_write(i) > 0)
                    live.push_back({process.index(), fifo.earliest_write(i) - fifo.shape().room_latency});
        }
    }
    return live;
}

PathSums sums_of(CoreTiming const& core) {
    std::size_t regions = 0, ports = 0;
    for (ProcessTiming const& process : core.processes()) {
        regions = std::max<std::size_t>(regions, Region::count(static_cast<unsigned>(process.loops().size())));
        ports = std::max(ports, process.port_count());
    }
    return {core.processes().size(), regions, ports};
}
}  // namespace

PathSweep::PathSweep(CoreTiming const& core, std::vector<Position> const& from)
    : core_(core),
      trail_(*core.trail()),
      standing_(2 * core.processes().size()),
      sums_(sums_of(core)),
      next_event_(trail_.events().size()),
      next_transition_(trail_.transitions().size()) {
    for (Position const& position : from)
        stand(position);
}

PathSweep PathSweep::from_here() const {
    PathSweep sweep(core_, {position()});
    sweep.next_event_ = next_event_;
    sweep.next_transition_ = next_transition_;
    return sweep;
}

PathSweep::Position PathSweep::position() const {
    auto const occupied = [](std::vector<Cycles> const& times) { return !times.empty(); };
    auto const found = std::find_if(standing_.begin(), standing_.end(), occupied);
    auto const number = static_cast<std::size_t>(found - standing_.begin());
    std::size_t const processes = standing_.size() / 2;
    return {static_cast<unsigned>(number % processes), found->back(), number >= processes};
}

void PathSweep::stand(Position position) {
    std::vector<Cycles>& times = standing_[place(position)];
    auto const place = std::lower_bound(times.begin(), times.end(), position.time);
    if (place != times.end() && *place == position.time)
        return;
    times.insert(place, position.time);
    ++positions_;
}

void PathSweep::to_the_start() {
    while (next_event_ > 0)
        pass_next();
    if (trail_.junction())
        sums_.add(trail_.junction()->sums);
    else
        add_own(position().process, Region(), 0, position().time);
}

bool PathSweep::to_a_junction() {
    while (positions_ > 1 && next_event_ > 0)
        pass_next();
    return positions_ == 1 && next_event_ > 0 && position().time != everything && !position().flies;
}

void PathSweep::pass_next() {
    --next_event_;
    TrailEvent const& event = trail_.events()[next_event_];
    if (event.kind == Kind::followed)
        pass_followed(event);
    else
        pass_one(trail_.events(), next_event_, 0);
}

/// Events [from, until), backwards.
void PathSweep::pass(Events const& events, std::size_t from, std::size_t until, Cycles later) {
    for (std::size_t i = until; i-- > from;)
        pass_one(events, i, later);
}

void PathSweep::pass_one(Events const& events, std::size_t i, Cycles later) {
    TrailEvent const& event = events[i];
    if (event.kind == Kind::repeated)
        pass_repeated(events, i, later);
    else if (event.kind == Kind::flown)
        land(event, event.time + later);
    else
        turn(event, event.time + later);
}

/// The positions come again after some periods, as the times themselves did: then what the path collected in between
/// is multiplied.
void PathSweep::pass_repeated(Events const& events, std::size_t i, Cycles later) {
    TrailEvent const& event = events[i];
    Standing before;
    PathSums sums_before;
    std::uint32_t left_before = 0;
    std::uint32_t looks = 0;
    for (std::uint32_t left = periods_to_pass(events, i, later); left > 0; --left) {
        pass(events, i - event.distance, i, later + left * event.time);
        std::uint32_t const period = left_before - left;
        if (looks > 0 && is_earlier_by(before, period * event.time)) {
            std::uint32_t const times = (left - 1) / period;
            sums_.add(PathSums(sums_), sums_before, times);
            go_back(times * period * event.time);
            left -= times * period;
            looks = 0;
        } else if (is_power_of_two(++looks)) {
            before = standing_;
            sums_before = sums_;
            left_before = left;
        }
    }
}

/// All positions are what they were before, but for some cycles.
bool PathSweep::is_earlier_by(Standing const& before, Cycles cycles) const {
    auto const same_time = [cycles](Cycles was, Cycles is) { return was - cycles == is; };
    auto const same = [&](std::vector<Cycles> const& was, std::vector<Cycles> const& is) {
        return std::equal(was.begin(), was.end(), is.begin(), is.end(), same_time);
    };
    return std::equal(before.begin(), before.end(), standing_.begin(), standing_.end(), same);
}

void PathSweep::go_back(Cycles cycles) {
    for (std::vector<Cycles>& times : standing_)
        for (Cycles& time : times)
            time -= cycles;
}

/// Those behind all positions are passed over.
std::uint32_t PathSweep::periods_to_pass(Events const& events, std::size_t i, Cycles later) const {
    TrailEvent const& event = events[i];
    Cycles first = everything;
    Cycles latest = 0;
    for (std::size_t k = i - event.distance; k < i; ++k) {
        first = std::min(first, events[k].time + later);
        std::vector<Cycles> const& times = standing_[events[k].process];
        latest = std::max(latest, times.empty() ? 0 : times.back());
    }
    return latest < first ? 0
                          : static_cast<std::uint32_t>(std::min<Cycles>(event.count, (latest - first) / event.time));
}

void PathSweep::pass_followed(TrailEvent const& event) {
    Passages const& passages = *trail_.passages();
    Cycles end = event.time;
    for (std::uint32_t left = event.count; left > 0; --left) {
        Trail::Transition const transition = trail_.transitions()[--next_transition_];
        Cycles const begin = end - passages.cycles(transition);
        Events const& events = passages.trail(transition);
        pass(events, 0, events.size(), begin);
        end = begin;
    }
}

/// Moves those back to an event who are behind it.
void PathSweep::turn(TrailEvent const& event, Cycles time) {
    std::vector<Cycles>& times = standing_[event.process];
    if (times.empty() || times.back() < time)
        return;
    for (; !times.empty() && times.back() >= time; times.pop_back(), --positions_)
        add_own(event.process, event.region, event.count, times.back() - time);
    stand(event.kind == Kind::marked ? Position{event.process, time} : origin(event, time));
}

/// Moves those back to what decided when a token left a flushing pipeline who stand there.
void PathSweep::land(TrailEvent const& event, Cycles time) {
    std::vector<Cycles>& times = standing_[place({event.process, time, true})];
    if (times.empty() || times.back() != time)
        return;
    times.pop_back();
    --positions_;
    sums_.of(event.process, Region(), Share::flight) += event.count;
    bool const is_room = event.distance != 0;
    if (is_room)
        ++sums_.turns(event.process, Region(), event.port);
    stand(decided(core_, event.process, event.port, {time - event.count, is_room}));
}

/// The access that made the one legal that a process waited for until `time`.
PathSweep::Position PathSweep::origin(TrailEvent const& event, Cycles time) {
    ++sums_.turns(event.process, event.region, event.port);
    ProcessTiming const& process = core_.processes()[event.process];
    FifoShape const& shape = process.fifo(event.port).shape();
    auto const other = static_cast<unsigned>(core_.other_end(process, event.port));
    if (process.writes(event.port))
        return {other, time - shape.room_latency};
    return {other, time - shape.read_latency - shape.issue_latency, shape.flushing_stages > 0};
}

void PathSweep::add_own(unsigned process, Region region, Cycles step, Cycles cycles) {
    auto const add = [&](Share share, Cycles amount) { sums_.of(process, region, share) += amount; };
    if (region.part() != Region::Part::iterations) {
        add(Share::own, cycles);
        return;
    }
    InitiationInterval const& interval = core_.processes()[process].loops()[region.loop()].interval;
    if (interval.achieved == 1) {
        add(Share::own, cycles);
        return;
    }
    // What is below zero wraps, and is right again in the sum.
    IterationShares const all = shares_of(interval, interval.achieved);
    IterationShares const first = shares_of(interval, step);
    IterationShares const last = shares_of(interval, (step + cycles) % interval.achieved);
    Cycles const iterations = (step + cycles) / interval.achieved;
    add(Share::own, iterations * all.own + last.own - first.own);
    add(Share::recurrence, iterations * all.recurrence + last.recurrence - first.recurrence);
    add(Share::port_conflict, iterations * all.port_conflict + last.port_conflict - first.port_conflict);
}

PathSums critical_path(CoreTiming const& core, unsigned process, Cycles access) {
    PathSweep sweep(core, {{process, access}});
    sweep.to_the_start();
    return sweep.sums();
}

void forget_trunk(CoreTiming const& core, Trail& trail) {
    PathSweep live(core, live_positions(core));
    if (!live.to_a_junction()) {
        trail.accept_length();
        return;
    }
    PathSweep trunk = live.from_here();
    trunk.to_the_start();
    PathSweep::Position const junction = live.position();
    trail.forget(live.events_left(), live.transitions_left(), {junction.process, junction.time, trunk.sums()});
}

}  // namespace dataflow::timing
