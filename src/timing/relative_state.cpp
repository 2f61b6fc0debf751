#include "timing/relative_state.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace faster::timing {

bool RelativeState::known(ProcessTiming const& process, unsigned port) {
    FifoTiming const& fifo = process.fifo(port);
    return (process.writes(port) ? fifo.known_writes() : fifo.known_reads()) > 0;
}

Cycles RelativeState::earliest(ProcessTiming const& process, unsigned port) {
    FifoTiming const& fifo = process.fifo(port);
    return process.writes(port) ? fifo.earliest_write() : fifo.earliest_read();
}

/// No further access of the process is before this cycle: its local time, less what it will go back when it leaves a
/// loop whose last tokens are out before the last initiation interval is over.
Cycles RelativeState::not_before(unsigned member) const {
    ProcessTiming const& p = process(member);
    std::int64_t const drain = p.in_loop_ ? p.plans_[p.current_loop_].drain : 0;
    return p.time_ + static_cast<Cycles>(std::min<std::int64_t>(drain, 0));
}

std::uint8_t RelativeState::next_ports(unsigned member) const {
    ProcessTiming const& p = process(member);
    return p.log_.exhausted() ? outlooks_[member].next_ports : p.log_.front().ports();
}

/// The first port of the next step, in program order, whose earliest cycle is not known yet.
bool RelativeState::blocked_port(unsigned member, unsigned& port) const {
    if (member == 0 || outlooks_[member].frozen)
        return false;
    for (std::uint32_t mask = next_ports(member); mask != 0; mask &= mask - 1) {
        port = static_cast<unsigned>(__builtin_ctz(mask));
        if (!known(process(member), port))
            return true;
    }
    return false;
}

/// Only what the driver does, from its local time on, can free it.
bool RelativeState::waits_for_driver(unsigned member, unsigned depth) const {
    unsigned port = 0;
    if (!blocked_port(member, port) || depth > group_->members().size())
        return false;
    unsigned const other = group_->other_end(member, port);
    return other == 0 || waits_for_driver(other, depth + 1);
}

void RelativeState::charge(unsigned member, unsigned port, Cycles cycles) {
    ProcessTiming& p = process(member);
    if (p.writes(port)) {
        p.fifo(port).full_stall_cycles_ += cycles;
        p.full_stall_cycles_ += cycles;
    } else {
        p.fifo(port).empty_stall_cycles_ += cycles;
        p.empty_stall_cycles_ += cycles;
    }
}

RelativeState::Waiting RelativeState::park(unsigned member) {
    ProcessTiming& p = process(member);
    Waiting waiting;
    waiting.arrival = waiting.since = p.time_;
    parked_at_[member] = no_port;
    if (!waits_for_driver(member))
        return waiting;
    waiting.waits = blocked_port(member, waiting.port);
    parked_at_[member] = waiting.port;
    for (std::uint32_t mask = next_ports(member); mask != 0; mask &= mask - 1) {
        auto const port = static_cast<unsigned>(__builtin_ctz(mask));
        if (port == waiting.port)
            break;
        Cycles const later = std::max(p.time_, earliest(p, port));
        charge(member, port, later - p.time_);
        bool const waited = later > p.time_;
        p.time_ = later;
        if (waited && p.trail_ != nullptr)
            p.leave_trail(port);
    }
    waiting.since = p.time_;
    Cycles const base = not_before(0);
    if (p.time_ < base) {
        charge(member, waiting.port, base - p.time_);
        p.time_ = base;
    }
    return waiting;
}

void RelativeState::unpark(unsigned member, unsigned port, Cycles arrival, Cycles since) {
    ProcessTiming& p = process(member);
    if (port != no_port) {
        charge(member, port, since - p.time_);  // in two's complement: what was charged ahead is taken back
        // What the step has found already was there when the waiting began; the state only knows that it is there now.
        std::uint32_t const before = (1U << port) - 1U;
        for (std::uint32_t mask = next_ports(member) & before; mask != 0; mask &= mask - 1)
            make_legal(member, static_cast<unsigned>(__builtin_ctz(mask)), since);
        p.charged_until_ = since;
        p.arrival_ = arrival;
    }
    p.time_ = since;
}

void RelativeState::make_legal(unsigned member, unsigned port, Cycles from) {
    ProcessTiming const& p = process(member);
    FifoTiming& fifo = p.fifo(port);
    Cycles& earliest = p.writes(port) ? fifo.free_from_[(fifo.writes_ - fifo.room_) & fifo.index_mask_]
                                      : fifo.readable_from_[fifo.reads_ & fifo.index_mask_];
    earliest = std::min(earliest, from);
}

/// Where words are put down; times relative to a base.
class RelativeState::Pen {
  public:
    Pen(std::int64_t* words, Cycles base) : words_(words), base_(base) {}

    void put(std::int64_t word) { *words_++ = word; }
    void put_time(Cycles cycle) { put(look_at(cycle)); }
    std::int64_t look_at(Cycles cycle) {
        auto const distance = static_cast<std::int64_t>(cycle - base_);
        reach_ = std::max(reach_, std::abs(distance));
        return distance;
    }
    std::int64_t* end() const { return words_; }
    std::int64_t reach() const { return reach_; }

  private:
    std::int64_t* words_;
    Cycles base_;
    std::int64_t reach_ = 0;
};

bool RelativeState::save(Words& words, std::uint32_t with_logs) const {
    ProcessTiming const& driver = process(0);
    if (driver.in_loop_ && !driver.plans_[driver.current_loop_].aligned &&
        (driver.pipeline_.open || driver.pipeline_.gap_left > 0))
        return false;
    auto const members = static_cast<unsigned>(group_->members().size());
    if (std::size_t const most = most_words(with_logs); page_.size() < most)
        page_.resize(2 * most);
    Pen pen(page_.data(), driver.time_);
    std::array<Cycles, Transition::most_members> floors;
    for (unsigned m = 0; m < members; ++m) {
        save_process(m, m > 0 && ((with_logs >> m) & 1U) != 0, pen);
        floors[m] = not_before(m);
    }
    for (Group::Inner const& inner : group_->fifos())
        save_fifo(inner, floors[inner.reader], floors[inner.writer], pen);
    words.assign(page_.data(), pen.end());
    reach_ = pen.reach();
    return true;
}

std::size_t RelativeState::most_words(std::uint32_t with_logs) const {
    constexpr std::size_t own = 2, of_fifo = 1;
    std::size_t words = 0;
    for (unsigned m = 0; m < group_->members().size(); ++m) {
        ProcessTiming const& p = process(m);
        words += own + (((with_logs >> m) & 1U) != 0 ? p.log_.pending() : 0);
        words += p.in_loop_ ? p.plans_[p.current_loop_].longest_lag : 0;
    }
    for (Group::Inner const& inner : group_->fifos())
        words += of_fifo + inner.fifo->room_;
    return words;
}

void RelativeState::clear_logs(std::uint32_t members) {
    for (unsigned m = 0; m < group_->members().size(); ++m)
        if (((members >> m) & 1U) != 0)
            process(m).log_.clear();
}

void RelativeState::save_process(unsigned member, bool with_log, Pen& pen) const {
    ProcessTiming const& p = process(member);
    Outlook const& outlook = outlooks_[member];
    outlook.frozen ? pen.put(0) : pen.put_time(p.time_);
    std::int64_t const loop = p.in_loop_ ? std::int64_t{p.current_loop_} + 1 : 0;
    auto const begun =
        static_cast<std::int64_t>(p.in_loop_ ? std::min(p.iterations_, p.plans_[p.current_loop_].counting) : 0);
    std::uint32_t const waited_for = parked_at_[member] + 1;  // 0: none
    std::size_t const left = with_log ? p.log_.pending() : 0;
    pen.put(loop | (begun << begun_at) | (std::int64_t{outlook.next_ports} << next_ports_at) |
            (std::int64_t{outlook.frozen} << frozen_at) | (std::int64_t{waited_for} << waited_for_at) |
            (static_cast<std::int64_t>(left) << left_at));
    if (p.in_loop_ && !p.plans_[p.current_loop_].aligned) {
        ProcessTiming::LoopPlan const& plan = p.plans_[p.current_loop_];
        std::uint64_t const iteration = p.pipeline_.iteration;
        for (std::uint64_t lag = 1; lag <= plan.longest_lag; ++lag)
            pen.put(iteration < lag ? 0 : plan.delay_line[(iteration - lag) % plan.delay_line.size()]);
    }
    for (std::size_t i = 0; i < left; ++i)
        pen.put(static_cast<std::int64_t>(p.log_.begin()[i].code()));
}

/// Of its times only those that are not over, when neither end does anything before its floor: a time before that
/// decides nothing, it could as well be that time. Times never fall.
void RelativeState::save_fifo(Group::Inner const& inner, Cycles reader_floor, Cycles writer_floor, Pen& pen) const {
    FifoTiming const& fifo = *inner.fifo;
    std::uint64_t const tokens = fifo.known_reads();
    std::uint64_t const room = fifo.known_writes();
    std::uint64_t read_over = tokens;
    while (read_over > 0 && fifo.earliest_read(read_over - 1) > reader_floor)
        --read_over;
    std::uint64_t room_over = room;
    while (!outlooks_[inner.writer].frozen && room_over > 0 && fifo.earliest_write(room_over - 1) > writer_floor)
        --room_over;
    pen.put(static_cast<std::int64_t>(tokens | (read_over << over_at) | (room_over << room_over_at)));
    if (read_over > 0)
        pen.look_at(reader_floor);
    for (std::uint64_t i = read_over; i < tokens; ++i)
        pen.put_time(fifo.earliest_read(i));
    if (room_over > 0 && !outlooks_[inner.writer].frozen)
        pen.look_at(writer_floor);
    for (std::uint64_t i = room_over; i < room; ++i)
        pen.put_time(fifo.earliest_write(i));
}

void RelativeState::load(Words const& words, Cycles driver_time) {
    for (Group::Inner const& inner : group_->fifos()) {
        inner.fifo->writes_ = FifoTiming::first_token;
        inner.fifo->reads_ = FifoTiming::first_token;
        inner.fifo->max_occupancy_ = 0;
    }
    for (Group::Member const& member : group_->members())
        member.process->log_.clear();
    restore(words, driver_time, Past::is_over);
}

void RelativeState::forget_times() {
    for (Group::Inner const& inner : group_->fifos()) {
        std::fill(inner.fifo->readable_from_.begin(), inner.fifo->readable_from_.end(), 0);
        std::fill(inner.fifo->free_from_.begin(), inner.fifo->free_from_.end(), 0);
    }
}

void RelativeState::restore(Words const& words, Cycles driver_time) { restore(words, driver_time, Past::is_written); }

void RelativeState::restore(Words const& words, Cycles driver_time, Past past) {
    std::int64_t const* next = words.data();
    for (unsigned m = 0; m < group_->members().size(); ++m)
        next = restore_process(m, driver_time, next);
    for (Group::Inner const& inner : group_->fifos())
        next = restore_fifo(inner, driver_time, next, past);
}

std::int64_t const* RelativeState::restore_process(unsigned member, Cycles base, std::int64_t const* words) {
    ProcessTiming& p = process(member);
    p.time_ = base + static_cast<Cycles>(*words++);
    std::int64_t const flags = *words++;
    p.in_loop_ = (flags & 0xFF) != 0;
    if (p.in_loop_)
        p.current_loop_ = static_cast<unsigned>(flags & 0xFF) - 1;
    p.iterations_ = static_cast<std::uint64_t>(flags >> begun_at) & most_iterations;
    outlooks_[member] = {static_cast<std::uint8_t>(flags >> next_ports_at), ((flags >> frozen_at) & 1) != 0};
    parked_at_[member] = (static_cast<unsigned>(flags >> waited_for_at) & 0xFFU) - 1;
    p.front_ports_ = 0;
    p.run_.active = false;
    if (p.in_loop_ && !p.plans_[p.current_loop_].aligned) {
        ProcessTiming::LoopPlan& plan = p.plans_[p.current_loop_];
        p.pipeline_ = ProcessTiming::PipelinePosition{};
        ++p.pipeline_run_;
        p.pipeline_.iteration = plan.longest_lag;
        p.pipeline_.drain_left = plan.longest_lag;
        for (std::uint64_t lag = 1; lag <= plan.longest_lag; ++lag)
            plan.delay_line[(plan.longest_lag - lag) % plan.delay_line.size()] = static_cast<std::uint8_t>(*words++);
    }
    auto const left = static_cast<std::size_t>(flags >> left_at);
    for (std::size_t i = left; i > 0; --i)
        p.log_.put_back(Operation(static_cast<Operation::Code>(words[i - 1])));
    return words + left;
}

std::int64_t const* RelativeState::restore_fifo(Group::Inner const& inner, Cycles base, std::int64_t const* words,
                                                Past past) {
    FifoTiming& fifo = *inner.fifo;
    auto const counts = static_cast<std::uint64_t>(*words++);
    std::uint64_t const tokens = counts & most_tokens;
    std::uint64_t const read_over = (counts >> over_at) & most_tokens;
    std::uint64_t const room_over = (counts >> room_over_at) & most_tokens;
    fifo.writes_ = fifo.reads_ + tokens;
    std::uint64_t const room = fifo.known_writes();
    std::uint64_t const first_room = fifo.writes_ - fifo.room_;
    if (past == Past::is_written) {
        Cycles const reader_floor = not_before(inner.reader), writer_floor = not_before(inner.writer);
        for (std::uint64_t i = 0; i < read_over; ++i)
            fifo.readable_from_[(fifo.reads_ + i) & fifo.index_mask_] = reader_floor;
        for (std::uint64_t i = 0; i < room_over; ++i)
            fifo.free_from_[(first_room + i) & fifo.index_mask_] = writer_floor;
    }
    for (std::uint64_t i = read_over; i < tokens; ++i)
        fifo.readable_from_[(fifo.reads_ + i) & fifo.index_mask_] = base + static_cast<Cycles>(*words++);
    for (std::uint64_t i = room_over; i < room; ++i)
        fifo.free_from_[(first_room + i) & fifo.index_mask_] = base + static_cast<Cycles>(*words++);
    return words;
}

std::vector<Cycles> RelativeState::room_times(unsigned number) const {
    FifoTiming const& fifo = *group_->fifos()[number].fifo;
    std::vector<Cycles> times;
    for (std::uint64_t i = 0; i < fifo.known_writes(); ++i)
        times.push_back(fifo.earliest_write(i));
    return times;
}

void RelativeState::set_room_time(unsigned number, std::uint64_t i, Cycles cycle) {
    FifoTiming& fifo = *group_->fifos()[number].fifo;
    fifo.free_from_[(fifo.writes_ + i - fifo.room_) & fifo.index_mask_] = cycle;
}

void RelativeState::count_tokens() {
    for (Group::Inner const& inner : group_->fifos())
        inner.fifo->passed_ += loaded_reads(inner);
}

std::vector<std::uint64_t*> RelativeState::counters() const {
    std::vector<std::uint64_t*> counters;
    counters.reserve(64);
    for (Group::Member const& member : group_->members()) {
        ProcessTiming& p = *member.process;
        counters.push_back(&p.empty_stall_cycles_);
        counters.push_back(&p.full_stall_cycles_);
        for (unsigned i = 0; i < p.loops_.size(); ++i) {
            LoopCounters& loop = p.loop_counters_[i];
            counters.push_back(&loop.entries);
            counters.push_back(&loop.iterations);
            if (p.loops_[i].depth >= p.loops_[i].interval.achieved)
                continue;
            counters.push_back(&loop.recurrence_beyond_end);
            counters.push_back(&loop.port_conflict_beyond_end);
        }
    }
    for (Group::Inner const& inner : group_->fifos()) {
        counters.push_back(&inner.fifo->passed_);
        counters.push_back(&inner.fifo->full_stall_cycles_);
        counters.push_back(&inner.fifo->empty_stall_cycles_);
    }
    return counters;
}

}  // namespace faster::timing
