#include "timing/steady_state.hpp"

#include <algorithm>

#include "common/each_bit.hpp"

namespace faster::timing {

namespace {
constexpr unsigned most_looks = 256;       // without finding a period, before giving a run up
constexpr std::uint64_t most_room = 1024;  // tokens of FIFOs to compare at each look

bool is_power_of_two(unsigned value) { return (value & (value - 1)) == 0; }
}  // namespace

void SteadyState::observe(ProcessTiming& process, std::deque<ProcessTiming>& processes) {
    bool const led = leader_ != nullptr && leader_->is_running(1) && run_of(*leader_) == leader_run_;
    if (!led)
        follow(process);
    if (leader_ != &process || looks_ > most_looks || !find_group(processes))
        return;
    take(now_);
    if (looks_ > 0 && now_.relative == before_.relative && trail_remembers(before_))
        jump(now_);
    else if (is_power_of_two(++looks_))  // Brent: keep an ever older state to compare with, so that any period is found
        std::swap(before_, now_);
}

void SteadyState::follow(ProcessTiming& process) {
    leader_ = &process;
    leader_run_ = run_of(process);
    looks_ = 0;
}

/// A number that no two runs of a process have.
std::uint64_t SteadyState::run_of(ProcessTiming const& process) {
    return process.run_.active ? 2 * process.run_.number : 2 * process.pipeline_run_ + 1;
}

/// A mask: of the iterations at hand, and of those that an unaligned loop still has on their way.
std::uint32_t SteadyState::ports_of(ProcessTiming const& process) {
    std::uint32_t ports = process.log_.front().ports();
    if (!process.run_.active)
        for (std::uint8_t const begun : process.plans_[process.current_loop_].delay_line)
            ports |= begun;
    return ports;
}

std::uint32_t SteadyState::neighbours_of(ProcessTiming const& process) {
    if (process.run_.active)
        return process.run_.neighbours;
    std::uint32_t neighbours = 0;
    for_each_bit(ports_of(process), [&](unsigned port) { neighbours |= process.ports_[port].neighbour; });
    return neighbours;
}

bool SteadyState::accesses(ProcessTiming const& process, FifoTiming const& fifo) {
    for (std::uint32_t ports = ports_of(process); ports != 0; ports &= ports - 1)
        if (process.ports_[static_cast<unsigned>(__builtin_ctz(ports))].fifo == &fifo)
            return true;
    return false;
}

/// The leader and all it is coupled with; false if any of them is not in a run, so that its next access is not known.
bool SteadyState::find_group(std::deque<ProcessTiming>& processes) {
    group_.assign(1, leader_);
    fifos_.clear();
    for (std::size_t i = 0; i < group_.size(); ++i)
        if (!add_neighbours(*group_[i], processes))
            return false;
    std::uint64_t room = 0;
    for (FifoTiming const* fifo : fifos_)
        room += fifo->room_;
    if (room > most_room)
        looks_ = most_looks + 1;
    return room <= most_room;
}

bool SteadyState::add_neighbours(ProcessTiming const& member, std::deque<ProcessTiming>& processes) {
    for (std::uint32_t mask = neighbours_of(member); mask != 0; mask &= mask - 1) {
        ProcessTiming& other = processes[static_cast<std::size_t>(__builtin_ctz(mask))];
        if (!other.is_running(2))
            return false;
        if (std::find(group_.begin(), group_.end(), &other) == group_.end())
            group_.push_back(&other);
    }
    for (std::uint32_t ports = ports_of(member); ports != 0; ports &= ports - 1) {
        ProcessTiming::Port const& port = member.ports_[static_cast<unsigned>(__builtin_ctz(ports))];
        if (std::find(fifos_.begin(), fifos_.end(), port.fifo) != fifos_.end())
            continue;
        if (port.neighbour == 0 ||
            !accesses(processes[static_cast<std::size_t>(__builtin_ctz(port.neighbour))], *port.fifo))
            return false;
        fifos_.push_back(port.fifo);
    }
    return true;
}

/// Where an unaligned loop stands in its iteration, and what it has yet to write.
void SteadyState::take_pipeline(ProcessTiming const& process, std::vector<std::int64_t>& relative) {
    ProcessTiming::LoopPlan const& plan = process.plans_[process.current_loop_];
    ProcessTiming::PipelinePosition const& at = process.pipeline_;
    Operation const& operation = process.log_.front();
    std::uint64_t const begun = at.iteration + (at.open ? 1 : 0);
    std::uint64_t const lags = std::min<std::uint64_t>(begun, plan.delay_line.size());
    for (std::uint64_t const word :
         {std::uint64_t{operation.ports()}, std::uint64_t{operation.gap()}, std::uint64_t{at.open},
          std::uint64_t{at.phase}, at.offset, std::uint64_t{at.gap_left}, std::uint64_t{process.front_ports_}, lags})
        relative.push_back(static_cast<std::int64_t>(word));
    for (std::uint64_t lag = 1; lag <= lags; ++lag)
        relative.push_back(plan.delay_line[(begun - lag) % plan.delay_line.size()]);
}

void SteadyState::shift_pipeline(ProcessTiming& process, std::uint64_t iterations) {
    std::vector<std::uint8_t>& line = process.plans_[process.current_loop_].delay_line;
    std::rotate(line.rbegin(), line.rbegin() + static_cast<std::ptrdiff_t>(iterations % line.size()), line.rend());
    process.pipeline_.iteration += iterations;
}

void SteadyState::take(Snapshot& snapshot) const {
    Cycles const origin = leader_->time_;
    auto const since = [origin](Cycles cycle) { return static_cast<std::int64_t>(cycle - origin); };
    snapshot.trail_mark = leader_->trail() == nullptr ? 0 : leader_->trail()->mark();
    snapshot.relative.clear();
    snapshot.growing.assign(1, origin);
    for (ProcessTiming const* process : group_) {
        snapshot.relative.push_back(static_cast<std::int64_t>(process->index()));
        snapshot.relative.push_back(static_cast<std::int64_t>(run_of(*process)));
        snapshot.relative.push_back(since(process->time_));
        if (!process->run_.active)
            take_pipeline(*process, snapshot.relative);
        snapshot.growing.push_back(process->empty_stall_cycles_);
        snapshot.growing.push_back(process->full_stall_cycles_);
        snapshot.growing.push_back(process->iterations_);
    }
    for (FifoTiming const* fifo : fifos_) {
        snapshot.relative.push_back(static_cast<std::int64_t>(fifo->known_reads()));
        snapshot.relative.push_back(static_cast<std::int64_t>(fifo->max_occupancy_));
        // A time before the local time of who waits for it decides nothing: it could as well be that time.
        Cycles writer = 0;
        Cycles reader = 0;
        for (ProcessTiming const* process : group_)
            for_each_bit(ports_of(*process), [&](unsigned port) {
                if (process->ports_[port].fifo == fifo)
                    (process->ports_[port].writes ? writer : reader) = process->time_;
            });
        for (std::uint64_t i = 0; i < fifo->known_reads(); ++i)
            snapshot.relative.push_back(since(std::max(reader, fifo->earliest_read(i))));
        for (std::uint64_t i = 0; i < fifo->known_writes(); ++i)
            snapshot.relative.push_back(since(std::max(writer, fifo->earliest_write(i))));
        snapshot.growing.push_back(fifo->writes_);
        snapshot.growing.push_back(fifo->full_stall_cycles_);
        snapshot.growing.push_back(fifo->empty_stall_cycles_);
    }
}

std::uint64_t SteadyState::whole_periods_left(Snapshot const& now) const {
    std::uint64_t periods = ~std::uint64_t{0};
    for (std::size_t i = 0; i < group_.size(); ++i) {
        Operation const& operation = group_[i]->log_.front();
        std::uint64_t const iterations = now.growing[3 * i + 3] - before_.growing[3 * i + 3];
        std::uint64_t const done = iterations / (1U + operation.gap());
        if (done == 0)
            return 0;
        periods = std::min(periods, (operation.count() - 1) / done);
    }
    return periods;
}

void SteadyState::jump(Snapshot const& now) {
    std::uint64_t const periods = whole_periods_left(now);
    auto const growth = [&](std::size_t i) { return periods * (now.growing[i] - before_.growing[i]); };
    if (periods == 0)
        return;
    std::size_t at = 0;
    Cycles const cycles = growth(at++);
    leave_trail(periods, cycles / periods);
    for (ProcessTiming* process : group_) {
        process->time_ += cycles;
        process->empty_stall_cycles_ += growth(at++);
        process->full_stall_cycles_ += growth(at++);
        std::uint64_t const iterations = growth(at++);
        process->iterations_ += iterations;
        if (!process->run_.active)
            shift_pipeline(*process, iterations);
        process->loop_counters_[process->current_loop_].iterations += iterations;
        Operation& operation = process->log_.front();
        operation.subtract(static_cast<std::uint32_t>(iterations / (1U + operation.gap())));
    }
    for (FifoTiming* fifo : fifos_) {
        shift(*fifo, growth(at), cycles);
        fifo->full_stall_cycles_ += growth(at + 1);
        fifo->empty_stall_cycles_ += growth(at + 2);
        at += 3;
    }
    looks_ = 0;
}

void SteadyState::leave_trail(std::uint64_t periods, Cycles cycles) const {
    std::uint32_t mask = 0;
    for (ProcessTiming const* process : group_)
        mask |= 1U << process->index();
    if (leader_->trail() != nullptr)
        leader_->trail()->repeated(before_.trail_mark, mask, periods, cycles);
}

bool SteadyState::trail_remembers(Snapshot const& snapshot) const {
    return leader_->trail() == nullptr || leader_->trail()->remembers(snapshot.trail_mark);
}

/// As if `tokens` more had gone through in `cycles`, and nothing else had changed.
void SteadyState::shift(FifoTiming& fifo, std::uint64_t tokens, Cycles cycles) {
    std::vector<Cycles> readable;
    std::vector<Cycles> writable;
    for (std::uint64_t i = 0; i < fifo.known_reads(); ++i)
        readable.push_back(fifo.earliest_read(i) + cycles);
    for (std::uint64_t i = 0; i < fifo.known_writes(); ++i)
        writable.push_back(fifo.earliest_write(i) + cycles);
    fifo.writes_ += tokens;
    fifo.reads_ += tokens;
    for (std::uint64_t i = 0; i < readable.size(); ++i)
        fifo.readable_from_[(fifo.reads_ + i) & fifo.index_mask_] = readable[i];
    for (std::uint64_t i = 0; i < writable.size(); ++i)
        fifo.free_from_[(fifo.writes_ + i - fifo.room_) & fifo.index_mask_] = writable[i];
}

}  // namespace faster::timing
