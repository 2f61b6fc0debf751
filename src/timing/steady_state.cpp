#include "timing/steady_state.hpp"

#include <algorithm>

namespace faster::timing {

namespace {
constexpr unsigned most_looks = 256;       // without finding a period, before giving a run up
constexpr std::uint64_t most_room = 1024;  // tokens of FIFOs to compare at each look

bool is_power_of_two(unsigned value) { return (value & (value - 1)) == 0; }
}  // namespace

void SteadyState::observe(ProcessTiming& process, std::deque<ProcessTiming>& processes) {
    bool const led = leader_ != nullptr && leader_->run_.active && leader_->run_.number == leader_run_;
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
    leader_run_ = process.run_.number;
    looks_ = 0;
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
    return room <= most_room;
}

bool SteadyState::add_neighbours(ProcessTiming const& member, std::deque<ProcessTiming>& processes) {
    for (std::uint32_t mask = member.run_.neighbours; mask != 0; mask &= mask - 1) {
        ProcessTiming& other = processes[static_cast<std::size_t>(__builtin_ctz(mask))];
        if (!other.run_.active || other.log_.front().count() < 2)
            return false;
        if (std::find(group_.begin(), group_.end(), &other) == group_.end())
            group_.push_back(&other);
    }
    for (unsigned i = 0; i < member.run_.size; ++i) {
        FifoTiming* const fifo = member.run_.fifos[i];
        auto const takes_part = [fifo](ProcessTiming const* process) {
            auto const* first = process->run_.fifos;
            return std::find(first, first + process->run_.size, fifo) != first + process->run_.size;
        };
        if (std::find(fifos_.begin(), fifos_.end(), fifo) != fifos_.end())
            continue;
        if (std::count_if(group_.begin(), group_.end(), takes_part) != 2)
            return false;
        fifos_.push_back(fifo);
    }
    return true;
}

void SteadyState::take(Snapshot& snapshot) const {
    Cycles const origin = leader_->time_;
    auto const since = [origin](Cycles cycle) { return static_cast<std::int64_t>(cycle - origin); };
    snapshot.trail_mark = leader_->trail() == nullptr ? 0 : leader_->trail()->mark();
    snapshot.relative.clear();
    snapshot.growing.assign(1, origin);
    for (ProcessTiming const* process : group_) {
        snapshot.relative.push_back(static_cast<std::int64_t>(process->index()));
        snapshot.relative.push_back(static_cast<std::int64_t>(process->run_.number));
        snapshot.relative.push_back(since(process->time_));
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
            for (unsigned i = 0; i < process->run_.size; ++i)
                if (process->run_.fifos[i] == fifo)
                    (process->run_.writes ? writer : reader) = process->time_;
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
