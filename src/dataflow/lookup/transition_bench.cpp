#include "dataflow/lookup/transition_bench.hpp"

#include <algorithm>
#include <cstdlib>

#include "dataflow/base/each_bit.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/lookup/relative_state.hpp"

namespace dataflow::timing {

TransitionBench::TransitionBench(CoreTiming const& core, Lead const& lead, bool leaves_trails)
    : shape_(core.blank_copy()), trail_(leaves_trails ? std::make_unique<Trail>(Trail::any_length) : nullptr) {
    Group const group(*shape_, lead);
    for (Group::Inner const& inner : group.fifos())
        fifos_.push_back({BenchFifo(inner.fifo->shape()), inner.writer, inner.reader});
    for (Fifo const& fifo : fifos_)
        words_of_fifos_ += FifoCounts::words + fifo.fifo.room;
    for (std::uint32_t number = 0; number < RelativeState(group).blocks(); ++number)
        figures_.push_back(FigureBlock::none(static_cast<std::uint16_t>(number)));
    for (Group::Member const& member : group.members()) {
        members_.push_back({BenchProcess(*member.process, figures_.data() + of_loops_, trail_.get())});
        of_loops_ += RelativeState::blocks_of(*member.process);
    }
    supplier_ = group.supplier();
    supplier_port_ = group.members()[supplier_].anchor_port;
    is_fed_ = group.fed() != 0;
    connect(group);
}

TransitionBench::~TransitionBench() = default;

/// From here on, nothing moves: ports point into FIFOs.
void TransitionBench::connect(Group const& group) {
    for (unsigned m = 0; m < members_.size(); ++m)
        for_each_bit(group.members()[m].inner_ports, [&](unsigned number) {
            unsigned const f = group.fifo_at(m, number);
            Fifo& fifo = fifos_[f];
            bool const writes = group.members()[m].process->writes(number);
            BenchPort port;
            port.end = writes ? fifo.fifo.writer() : fifo.fifo.reader();
            port.number = number;
            port.other = group.other_end(m, number);
            port.fifo = 1U << f;
            port.stalls = &figures_[of_loops_ + f].sums[writes ? 1 : 2];
            members_[m].process.connect(port);
        });
}

void TransitionBench::go_to(StateView state) {
    base_ = 0;
    StateWord const* words = state.words;
    for (Member& member : members_)
        words = member.process.load(words);
    for (Fifo& fifo : fifos_)
        words = load_fifo(fifo.fifo, 0, BenchLine::over, BenchLine::over, words);
    accessed_ = 0;
}

void TransitionBench::start() {
    for (Member& member : members_) {
        member.process.start();
        member.time_before = member.process.time();
        member.port_before = member.process.parked_at();
        member.has_accessed = false;
    }
    for_each_bit(accessed_, [this](unsigned f) { fifos_[f].fifo.start(); });
    accessed_ = 0;
}

/// Until nobody can do anything. Those who are told first, who mostly come first on the way of a token, first; again
/// those who were waiting for what somebody has done.
void TransitionBench::settle() {
    std::uint32_t runnable = 0;
    std::uint32_t awaited = 0;  // FIFOs
    for (unsigned m = 0; m < members_.size(); ++m)
        runnable |= members_[m].process.finished() ? 0 : 1U << m;
    while (runnable != 0) {
        auto const m = static_cast<unsigned>(__builtin_ctz(runnable));
        runnable &= ~(1U << m);
        BenchProcess& process = members_[m].process;
        std::uint32_t const accessed = process.advance();
        accessed_ |= accessed;
        members_[m].has_accessed = members_[m].has_accessed || accessed != 0;
        for_each_bit(accessed & awaited, [&](unsigned f) { runnable |= 1U << fifos_[f].other_end(m); });
        awaited &= ~accessed;
        awaited |= process.finished() ? 0 : process.blocked_at();
    }
}

/// The first port of the next step, in program order, whose earliest cycle is not known yet.
unsigned TransitionBench::blocked_port(unsigned member) const {
    BenchProcess const& process = members_[member].process;
    if (member == 0 || process.is_frozen())
        return BenchProcess::no_port;
    if (process.awaits_room())
        return process.flushing_port();
    for (std::uint32_t mask = process.next_ports(); mask != 0; mask &= mask - 1) {
        auto const port = static_cast<unsigned>(__builtin_ctz(mask));
        if (!process.is_known(port))
            return port;
    }
    return BenchProcess::no_port;
}

/// At its blocked_port(): only what the driver does, from its local time on, can free it.
bool TransitionBench::waits_for_driver(unsigned member, unsigned port, unsigned depth) const {
    if (port == BenchProcess::no_port || depth > members_.size())
        return false;
    unsigned const other = members_[member].process.port(port).other;
    return other == 0 || waits_for_driver(other, blocked_port(other), depth + 1);
}

/// Of a member with a flushing pipeline: lets that take in bubbles until the driver's local time, before which there is
/// nothing to read, or until it stands still. The port it waits at then.
unsigned TransitionBench::port_that_freezes(unsigned member) {
    BenchProcess& process = members_[member].process;
    std::uint32_t const reads = process.next_ports() & ~(1U << process.flushing_port());
    if (reads == 0)
        return BenchProcess::no_port;
    auto const port = static_cast<unsigned>(__builtin_ctz(reads));
    bool const is_known = process.is_known(port);
    if (is_known ? !process.awaits_room() : !waits_for_driver(member, port))
        return BenchProcess::no_port;
    std::int64_t const until = is_known ? process.port(port).end.earliest() : members_.front().process.not_before();
    if (process.idle_until(until, port))
        return process.flushing_port();
    return is_known ? BenchProcess::no_port : port;
}

/// Charges a follower that waits for the driver with the cycles up to the driver's local time: whatever it waits for
/// cannot come earlier. Adds what it was charged with for other ports of the same step to `waits`.
TransitionBench::Waiting TransitionBench::park_follower(unsigned member, std::vector<Transition::Stand>& waits) {
    BenchProcess& process = members_[member].process;
    unsigned const port_before = members_[member].still_stands() ? members_[member].port_before : BenchProcess::no_port;
    auto const is_over = [&](unsigned port) {
        waits.push_back({static_cast<std::int32_t>(process.time() - base_), 0, static_cast<std::int16_t>(port),
                         static_cast<std::uint8_t>(member), false, true});
    };
    Waiting waiting;
    waiting.arrival = waiting.since = process.time();
    unsigned const port = process.flushes() ? port_that_freezes(member) : blocked_port(member);
    if (!waits_for_driver(member, port)) {
        process.set_parked_at(BenchProcess::no_port);
        if (port_before != BenchProcess::no_port && !process.flushes())
            is_over(port_before);
        return waiting;
    }
    waiting.waits = true;
    waiting.port = port;
    process.set_parked_at(port);
    if (process.flushes()) {
        process.wait(port, members_.front().process.not_before());
        return waiting;
    }
    for_each_bit(process.next_ports() & ((1U << port) - 1U), [&](unsigned before) {
        std::int64_t const arrival = process.time();
        process.wait(before, process.port(before).end.earliest());
        if (process.time() > arrival && trail_ != nullptr)
            process.leave_trail(before);
        if (process.time() > arrival || before == port_before)
            is_over(before);
    });
    waiting.since = process.time();
    process.wait(port, members_.front().process.not_before());
    return waiting;
}

std::vector<TransitionBench::Waiting> TransitionBench::park(FigureBlocks& figures,
                                                            std::vector<Transition::Stand>& waits) {
    start();
    std::vector<Waiting> waitings;
    for (unsigned m = 1; m < members_.size(); ++m)
        waitings.push_back(park_follower(m, waits));
    take_figures(figures);
    save();
    return waitings;
}

/// What has been left since the last call.
std::vector<TrailEvent> TransitionBench::take_trail(std::int64_t since) {
    return trail_ != nullptr ? trail_->take(static_cast<Cycles>(since)) : std::vector<TrailEvent>();
}

void TransitionBench::tell(Task const& task, Transition& transition) {
    Phrase::each(
        task.codes, task.size,
        [this](unsigned member, Operation const& operation) { members_[member].process.append(operation); },
        [&](unsigned member, Ports::Number next_ports, bool frozen) {
            transition.notes.froze |= frozen ? 1U << member : 0U;
            members_[member].process.set_outlook(next_ports, frozen);
        });
    if (task.supplies == 0)
        return;
    auto const ports = static_cast<Ports::Number>(1U << supplier_port_);
    members_[supplier_].process.append(Operation::mix(ports, task.supplies, 0));
    members_[supplier_].process.set_outlook(ports, false);
}

bool TransitionBench::work_out(Task const& task, Transition& transition) {
    start();
    tell(task, transition);
    settle();
    std::int64_t const begin = base_;
    if (!members_.front().process.finished() || froze_too_early(transition) || !describe(transition)) {
        take_trail(0);  // it came to nothing
        for (FigureBlock& block : figures_)
            block = FigureBlock::none(block.number);
        return false;
    }
    describe_stands(task.active, transition);
    take_figures(transition.figures);
    transition.trail = take_trail(begin);
    save();
    return true;
}

/// Who is out of the game has to have done all before: where it finds room for that, its state does not tell any more.
bool TransitionBench::froze_too_early(Transition const& transition) const {
    bool too_early = false;
    for_each_bit(transition.notes.froze, [&](unsigned m) { too_early = too_early || !members_[m].process.finished(); });
    return too_early;
}

/// What it takes, and of loops. False if times are no longer sure to fit into words.
bool TransitionBench::describe(Transition& transition) {
    std::int64_t furthest = 0;
    bool froze = false;
    for (unsigned m = 0; m < members_.size(); ++m) {
        BenchProcess const& process = members_[m].process;
        furthest = std::max(furthest, std::abs(process.time() - base_));
        transition.entered |= process.has_entered() ? 1U << m : 0U;
        transition.iterations[m] = process.iterations();
        froze = froze || process.is_frozen();
    }
    if (furthest > furthest_apart)
        return false;
    transition.cycles = static_cast<Cycles>(members_.front().process.time() - base_);
    base_ = members_.front().process.time();
    if (froze)
        describe_rooms(transition);
    if (is_fed_)
        describe_fed(transition);
    return true;
}

/// For the driver alone, as before the transition, in which it did nothing.
bool TransitionBench::goes_on_waiting(unsigned member) {
    BenchProcess& process = members_[member].process;
    unsigned const port = process.parked_at();
    if (port == BenchProcess::no_port || process.holds_tokens() || process.time() != members_[member].time_before ||
        process.port(port).other != 0 || process.is_known(port))
        return false;
    process.wait(port, members_.front().process.not_before());
    return true;
}

void TransitionBench::describe_stands(std::uint32_t told, Transition& transition) {
    for (unsigned m = 1; m < members_.size(); ++m) {
        // One that is told nothing may go on with what it was told before.
        bool const active = ((told >> m) & 1U) != 0 || members_[m].has_accessed;
        if (!active && (members_[m].process.is_frozen() || goes_on_waiting(m)))
            continue;
        bool const stays = members_[m].still_stands();
        std::vector<Transition::Stand> waits;
        Waiting const waiting = park_follower(m, waits);
        if (stays && waiting.port == members_[m].port_before)
            continue;
        transition.stands.push_back(
            {static_cast<std::int32_t>(waiting.since - base_), static_cast<std::int32_t>(waiting.arrival - base_),
             static_cast<std::int16_t>(waiting.port), static_cast<std::uint8_t>(m), active && !stays, false});
        transition.stands.insert(transition.stands.end(), waits.begin(), waits.end());
    }
}

/// All a frozen writer needs to know later, which its state does not say: room from before it froze is room when it
/// froze.
void TransitionBench::describe_rooms(Transition& transition) {
    for (unsigned f = 0; f < fifos_.size(); ++f) {
        BenchProcess const& writer = members_[fifos_[f].writer].process;
        if (!writer.is_frozen())
            continue;
        BenchLine const& free = fifos_[f].fifo.free;
        bool const froze = ((transition.notes.froze >> fifos_[f].writer) & 1U) != 0;
        std::uint64_t const fresh = froze ? free.known() : std::min(free.known(), free.appended());
        Transition::Room room{f, froze, {}};
        for (std::uint64_t i = free.known() - fresh; i < free.known(); ++i)
            room.from.push_back((froze ? std::max<std::int64_t>(free[i], writer.time()) : free[i]) - base_);
        if (froze || fresh > 0)
            transition.notes.rooms.push_back(std::move(room));
    }
}

/// What it takes, the supplier takes in the step in which it writes.
void TransitionBench::describe_fed(Transition& transition) {
    if (members_[supplier_].process.is_frozen() || !members_[supplier_].has_accessed)
        return;
    FifoEnd<BenchLine> const& end = members_[supplier_].process.port(supplier_port_).end;
    for (std::uint64_t i = 0; i < end.appends->appended(); ++i)
        transition.notes.fed.push_back(end.appends->fresh()[i] - end.later - base_);
}

/// Those of whatever has done something, which are zero behind this.
void TransitionBench::take_figures(FigureBlocks& figures) {
    figures.resize(figures_.size());  // room for all
    FigureBlock* next = figures.data();
    auto const take = [&next](FigureBlock& block) {
        *next++ = block;
        block = FigureBlock::none(block.number);
    };
    std::uint32_t touched = accessed_;
    for (Member const& member : members_) {
        member.process.each_figures(take);
        touched |= member.process.waited();
    }
    for_each_bit(touched, [&](unsigned f) {
        Fifo const& fifo = fifos_[f];
        FigureBlock& block = figures_[of_loops_ + f];
        block.sums[0] = static_cast<std::uint32_t>(fifo.fifo.readable.consumed());
        block.largest = static_cast<std::uint16_t>(fifo.fifo.largest_occupancy());
        take(block);
    });
    figures.resize(static_cast<std::size_t>(next - figures.data()));
}

void TransitionBench::save() {
    std::size_t most = words_of_fifos_;
    for (Member const& member : members_)
        most += member.process.most_words();
    page_.start(base_, most);
    for (Member& member : members_)
        member.process.save(page_);
    for (Fifo const& fifo : fifos_) {
        BenchProcess const& writer = members_[fifo.writer].process;
        save_fifo(fifo.fifo, members_[fifo.reader].process.not_before(), writer.not_before(), writer.is_frozen(),
                  page_);
    }
}

}  // namespace dataflow::timing
