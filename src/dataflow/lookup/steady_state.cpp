#include "dataflow/lookup/steady_state.hpp"

#include <algorithm>

#include "dataflow/base/each_bit.hpp"
#include "dataflow/base/integer_bits.hpp"

namespace dataflow::timing {

namespace {
constexpr unsigned most_looks = 256;        // without finding a period, before giving a run up
constexpr unsigned most_others = 16;        // that go on between two looks
constexpr std::uint64_t most_times = 1024;  // of FIFOs, to compare at each look
constexpr unsigned longest_pause = 15;      // of calls in which a group is not looked for
// Iterations that others must have left, or a period would hardly come again.
constexpr std::uint32_t fewest_iterations = 16;

using View = ProcessTiming::View;
}  // namespace

ProcessMask SteadyState::observe(ProcessTiming& process, std::deque<ProcessTiming>& processes) {
    if (given_up_[process.index()] == View(process).run() || !leads(process) || !has_group(processes))
        return 0;
    take(now_);
    if (looks_ > 0 && now_.relative == before_.relative && trail_remembers(before_))
        return jump(now_);
    if (is_power_of_two(++looks_))  // Brent: keep an ever older state to compare with, so that any period is found
        std::swap(before_, now_);
    if (looks_ > most_looks)
        give_up();
    return 0;
}

/// Who leads does so until its run is over, or others go on much more often.
bool SteadyState::leads(ProcessTiming& process) {
    bool const led = leader_ != nullptr && leader_->is_running(1) && View(*leader_).run() == leader_run_;
    if (!led || (leader_ != &process && ++others_ > most_others)) {
        leader_ = &process;
        leader_run_ = View(process).run();
        looks_ = 0;
    }
    if (leader_ == &process)
        others_ = 0;
    return leader_ == &process;
}

void SteadyState::give_up() {
    for (ProcessTiming* member : group_)
        given_up_[member->index()] = View(*member).run();
    leader_ = nullptr;
}

/// Of the iterations at hand, and of those that an unaligned loop still has on their way.
Ports SteadyState::ports_of(ProcessTiming& process) {
    Ports ports(process.log().front().ports());
    for (std::uint64_t lag = first_lag(process), lags = lags_of(process); lag <= lags; ++lag)
        ports = ports | Ports(View(process).state().delayed(lag));
    return ports;
}

/// Iterations whose ports are in the delay line, before the next one to begin; and the place of the latest.
std::uint64_t SteadyState::lags_of(ProcessTiming& process) {
    View const view(process);
    return view.plan().aligned ? 0 : std::min(view.state().pipeline.iteration, view.plan().longest_lag);
}
std::uint64_t SteadyState::first_lag(ProcessTiming& process) { return View(process).state().pipeline.open ? 0 : 1; }

bool SteadyState::accesses(ProcessTiming& process, FifoTiming const& fifo) {
    bool accesses = false;
    for (ProcessPort const& port : View(process).port_set(ports_of(process).number()))
        accesses = accesses || port.fifo == &fifo;
    return accesses;
}

/// Found now. Where it was not lately, it is looked for in some of the calls only.
bool SteadyState::has_group(std::deque<ProcessTiming>& processes) {
    Pause& pause = pauses_[leader_->index()];
    if (pause.left > 0) {
        --pause.left;
        return false;
    }
    bool const found = find_group(processes);
    pause.calls = found ? 0 : std::min(2 * pause.calls + 1, longest_pause);
    pause.left = pause.calls;
    return found;
}

/// The leader and all it is coupled with; false if any of them is not in a run, so that its next access is not known.
bool SteadyState::find_group(std::deque<ProcessTiming>& processes) {
    group_.assign(1, leader_);
    ends_.clear();
    fifos_.clear();
    for (std::size_t i = 0; i < group_.size(); ++i)
        if (!add_ends(*group_[i], processes))
            return false;
    std::uint64_t times = 0;
    for (End const& end : ends_) {
        times += end.open() ? 0 : end.known();
        if (end.writes && is_between_closed_ends(*end.fifo))
            fifos_.push_back(end.fifo);
    }
    if (times > most_times)
        give_up();
    return times <= most_times;
}

/// Of a member, which makes the processes behind those that are closed members as well.
bool SteadyState::add_ends(ProcessTiming& member, std::deque<ProcessTiming>& processes) {
    for (ProcessPort const& port : View(member).port_set(ports_of(member).number())) {
        End end{&member, port.number, port.fifo, port.writes, 0};
        end.free = free_accesses(end);
        ends_.push_back(end);
        if (end.open())
            continue;
        if (port.neighbour == 0 || (end.writes && end.fifo->is_unlimited()))
            return false;
        ProcessTiming& other = processes[static_cast<std::size_t>(__builtin_ctzll(port.neighbour))];
        if (!other.is_running(fewest_iterations) || !accesses(other, *port.fifo))
            return false;
        if (std::find(group_.begin(), group_.end(), &other) == group_.end())
            group_.push_back(&other);
    }
    return true;
}

/// Accesses of a run are an initiation interval apart at least. What that says of those to come is kept by port,
/// so that each is looked at once.
std::uint64_t SteadyState::free_accesses(End const& end) {
    if (end.writes && end.fifo->is_unlimited())
        return end.known();
    View const process(*end.process);
    FreeAccesses& known = known_free(end);
    std::uint64_t const next = end.accesses();
    if (known.in_run != process.run() || known.until < next) {
        known.in_run = process.run();
        known.until = next;
    }
    std::uint64_t free = known.until - next;
    Cycles const interval = process.plan().ii;
    Cycles const time = process.state().time;
    if (free < end.known() && end.earliest(end.known() - 1) <= time + free * interval)
        free = end.known();  // none is legal later than the one behind it
    while (free < end.known() && end.earliest(free) <= time + free * interval)
        ++free;
    known.until = next + free;
    return free;
}

SteadyState::FreeAccesses& SteadyState::known_free(End const& end) {
    std::vector<FreeAccesses>& of_ports = free_[end.process->index()];
    if (of_ports.size() <= end.port)
        of_ports.resize(end.process->port_count());
    return of_ports[end.port];
}

bool SteadyState::is_between_closed_ends(FifoTiming const& fifo) const {
    return 2 == std::count_if(ends_.begin(), ends_.end(),
                              [&fifo](End const& end) { return end.fifo == &fifo && !end.open(); });
}

/// Where an unaligned loop stands in its iteration, and what it has yet to write.
void SteadyState::take_pipeline(ProcessTiming& process, std::vector<std::int64_t>& relative) {
    ProcessState<Cycles> const& state = View(process).state();
    PipelinePosition const& at = state.pipeline;
    Operation const& operation = process.log().front();
    std::uint64_t const lags = lags_of(process);
    for (std::uint64_t const word :
         {std::uint64_t{operation.ports()}, std::uint64_t{operation.gap()}, std::uint64_t{at.open},
          std::uint64_t{at.phase}, at.offset, std::uint64_t{at.gap_left}, lags})
        relative.push_back(static_cast<std::int64_t>(word));
    for (std::uint64_t lag = first_lag(process); lag <= lags; ++lag)
        relative.push_back(state.delayed(lag));
}

void SteadyState::shift_pipeline(ProcessTiming& process, std::uint64_t iterations) {
    ProcessState<Cycles>& state = View(process).state();
    std::vector<Ports::Number>& line = state.delay_line;
    std::rotate(line.rbegin(), line.rbegin() + static_cast<std::ptrdiff_t>(iterations % line.size()), line.rend());
    state.pipeline.iteration += iterations;
}

void SteadyState::take(Snapshot& snapshot) const {
    Cycles const origin = leader_->local_time();
    auto const since = [origin](Cycles cycle) { return static_cast<std::int64_t>(cycle - origin); };
    snapshot.trail_mark = leader_->trail() == nullptr ? 0 : leader_->trail()->mark();
    snapshot.relative.clear();
    snapshot.time = origin;
    snapshot.members.clear();
    snapshot.ends.clear();
    for (ProcessTiming* process : group_) {
        View const view(*process);
        snapshot.relative.push_back(static_cast<std::int64_t>(process->index()));
        snapshot.relative.push_back(static_cast<std::int64_t>(view.run()));
        snapshot.relative.push_back(since(process->local_time()));
        if (!view.plan().aligned)
            take_pipeline(*process, snapshot.relative);
        snapshot.members.push_back(
            {process->empty_stall_cycles(), process->full_stall_cycles(), process->iterations()});
    }
    for (FifoTiming const* fifo : fifos_)
        snapshot.relative.push_back(static_cast<std::int64_t>(fifo->max_occupancy()));
    for (End const& end : ends_) {
        snapshot.relative.push_back(end.open() ? 1 : 0);
        // An open end has made nobody wait since, or it would not go on like this.
        snapshot.relative.push_back(static_cast<std::int64_t>(end.open() ? end.stalls() : end.known()));
        // A time before the local time of who waits for it decides nothing: it could as well be that time.
        for (std::uint64_t i = 0; !end.open() && i < end.known(); ++i)
            snapshot.relative.push_back(since(std::max(end.process->local_time(), end.earliest(i))));
        snapshot.ends.push_back({end.accesses(), end.stalls()});
    }
}

std::uint64_t SteadyState::whole_periods_left(Snapshot const& now) const {
    std::uint64_t periods = ~std::uint64_t{0};
    for (std::size_t i = 0; i < group_.size(); ++i) {
        Operation const& operation = group_[i]->log().front();
        std::uint64_t const iterations = now.members[i].iterations - before_.members[i].iterations;
        std::uint64_t const done = iterations / (1U + operation.gap());
        if (done == 0)
            return 0;
        periods = std::min(periods, (operation.count() - 1) / done);
    }
    for (std::size_t i = 0; i < ends_.size(); ++i) {
        End const& end = ends_[i];
        std::uint64_t const accesses = now.ends[i].count - before_.ends[i].count;
        if (!end.open() || accesses == 0)
            continue;
        if (accesses > end.fifo->end(end.writes).appends->kept())
            return 0;  // repeat() goes by those of the last period
        periods = std::min(periods, end.free / accesses);
    }
    return periods;
}

ProcessMask SteadyState::jump(Snapshot const& now) {
    std::uint64_t const periods = whole_periods_left(now);
    if (periods == 0)
        return 0;
    Cycles const cycles = periods * (now.time - before_.time);
    leave_trail(periods, cycles / periods);
    for (std::size_t i = 0; i < group_.size(); ++i)
        repeat(*group_[i], before_.members[i], now.members[i], periods, cycles);
    // Open ends first, as who is behind them may need what they write or the room they make.
    for (bool const open : {true, false})
        for (std::size_t i = 0; i < ends_.size(); ++i)
            if (ends_[i].open() == open)
                go_on(ends_[i], periods * (now.ends[i].count - before_.ends[i].count),
                      periods * (now.ends[i].stalls - before_.ends[i].stalls), periods, cycles);
    looks_ = 0;
    return behind_open_ends();
}

void SteadyState::repeat(ProcessTiming& process, Snapshot::Done const& before, Snapshot::Done const& now,
                         std::uint64_t periods, Cycles cycles) {
    View const view(process);
    view.state().time += cycles;
    view.figures().empty_stall_cycles += periods * (now.empty_stalls - before.empty_stalls);
    view.figures().full_stall_cycles += periods * (now.full_stalls - before.full_stalls);
    std::uint64_t const iterations = periods * (now.iterations - before.iterations);
    view.state().iterations += iterations;
    if (!view.plan().aligned)
        shift_pipeline(process, iterations);
    view.figures().loops[view.state().loop].iterations += iterations;
    Operation& operation = process.log().front();
    operation.subtract(static_cast<std::uint32_t>(iterations / (1U + operation.gap())));
}

ProcessMask SteadyState::behind_open_ends() const {
    ProcessMask processes = 0;
    for (End const& end : ends_)
        processes |= end.open() ? View(*end.process).port(end.port).neighbour : 0U;
    return processes;
}

void SteadyState::go_on(End const& end, std::uint64_t accesses, Cycles stalls, std::uint64_t periods, Cycles cycles) {
    end.fifo->add_stall(end.writes, stalls);
    if (std::find(fifos_.begin(), fifos_.end(), end.fifo) == fifos_.end())
        repeat(end, accesses, periods, cycles);
    else if (end.writes)
        shift(*end.fifo, accesses, cycles);
}

void SteadyState::leave_trail(std::uint64_t periods, Cycles cycles) const {
    ProcessMask mask = 0;
    for (ProcessTiming const* process : group_)
        mask |= bit_of(process->index());
    if (leader_->trail() != nullptr)
        leader_->trail()->repeated(before_.trail_mark, mask, periods, cycles);
}

bool SteadyState::trail_remembers(Snapshot const& snapshot) const {
    return leader_->trail() == nullptr || leader_->trail()->remembers(snapshot.trail_mark);
}

/// As if `tokens` more had gone through in `cycles`, and nothing else had changed.
void SteadyState::shift(FifoTiming& fifo, std::uint64_t tokens, Cycles cycles) {
    FifoTiming::View const view(fifo);
    view.rules().readable.shift(tokens, cycles);
    view.rules().free.shift(tokens, cycles);
}

/// What happened in the last period happens again in each.
void SteadyState::repeat(End const& end, std::uint64_t accesses, std::uint64_t periods, Cycles cycles) {
    if (accesses == 0)
        return;
    FifoTiming::End const fifo_end = end.fifo->end(end.writes);
    CycleRing::Writer const line = fifo_end.appends->writer(accesses);
    std::uint64_t const in_period = accesses / periods;
    for (std::uint64_t i = 0; i < in_period; ++i) {
        Cycles cycle = line[i - in_period];
        for (std::uint64_t at = i; at < accesses; at += in_period)
            line[at] = cycle += cycles / periods;
    }
    fifo_end.consumes->consume(accesses);
    fifo_end.appends->done(accesses);
    end.fifo->note(end.writes, accesses);
}

}  // namespace dataflow::timing
