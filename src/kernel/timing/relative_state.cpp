#include "kernel/timing/relative_state.hpp"

#include <algorithm>
#include <cstdlib>

namespace faster::timing {

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

/// Where words are put down, with times since a base.
class RelativeState::Pen {
  public:
    Pen(StateWords& words, Cycles base) : words_(words), base_(base) { words_.clear(); }

    void put(StateWord word) { words_.push_back(word); }
    void put_time(Cycles cycle) {
        auto const distance = static_cast<std::int64_t>(cycle - base_);
        is_near_ = is_near_ && std::abs(distance) <= furthest_apart;
        put(static_cast<StateWord>(distance));
    }
    /// What puts so many words down.
    template <class Put> void put(std::size_t words, Put const& put) {
        words_.resize(words_.size() + words);
        put(words_.data() + words_.size() - words);
    }
    bool is_near() const { return is_near_; }

  private:
    StateWords& words_;
    Cycles base_;
    bool is_near_ = true;
};

bool RelativeState::save(StateWords& words, std::uint32_t with_logs) const {
    ProcessTiming const& driver = process(0);
    if (driver.in_loop_ && !driver.plans_[driver.current_loop_].aligned &&
        (driver.pipeline_.open || driver.pipeline_.gap_left > 0))
        return false;
    Pen pen(words, driver.time_);
    for (unsigned m = 0; m < group_->members().size(); ++m)
        save_process(m, m > 0 && ((with_logs >> m) & 1U) != 0, pen);
    for (Group::Inner const& inner : group_->fifos())
        save_fifo(inner, pen);
    return pen.is_near();
}

void RelativeState::clear_logs(std::uint32_t members) {
    for (unsigned m = 0; m < group_->members().size(); ++m)
        if (((members >> m) & 1U) != 0)
            process(m).log_.clear();
}

void RelativeState::save_process(unsigned member, bool with_log, Pen& pen) const {
    ProcessTiming const& p = process(member);
    Outlook const& outlook = outlooks_[member];
    ProcessFlags flags;
    flags.loop = p.in_loop_ ? p.current_loop_ + 1 : 0;
    flags.begun = p.in_loop_ ? std::min(p.iterations_, p.plans_[p.current_loop_].counting) : 0;
    flags.next_ports = outlook.next_ports;
    flags.frozen = outlook.frozen;
    flags.left = with_log ? p.log_.pending() : 0;
    if (outlook.frozen)
        pen.put(0);
    else
        pen.put_time(p.time_);
    pen.put(ProcessFlags::words, [&flags](StateWord* to) { flags.put(to); });
    if (p.in_loop_ && !p.plans_[p.current_loop_].aligned) {
        ProcessTiming::LoopPlan const& plan = p.plans_[p.current_loop_];
        std::uint64_t const iteration = p.pipeline_.iteration;
        for (std::uint64_t lag = 1; lag <= plan.longest_lag; ++lag)
            pen.put(iteration < lag ? 0 : plan.delay_line[(iteration - lag) % plan.delay_line.size()]);
    }
    for (std::size_t i = 0; i < flags.left; ++i)
        pen.put(words_of_operation, [&](StateWord* to) { put_code(p.log_.begin()[i].code(), to); });
}

/// Of its times only those that are not over, when neither end does anything before its floor: a time before that
/// decides nothing, it could as well be that time. Times never fall. Where a frozen writer finds room is told
/// elsewhere.
void RelativeState::save_fifo(Group::Inner const& inner, Pen& pen) const {
    FifoTiming const& fifo = *inner.fifo;
    bool const frozen = outlooks_[inner.writer].frozen;
    std::uint64_t const room = fifo.known_writes();
    FifoCounts counts;
    counts.tokens = counts.tokens_over = fifo.known_reads();
    while (counts.tokens_over > 0 && fifo.earliest_read(counts.tokens_over - 1) > not_before(inner.reader))
        --counts.tokens_over;
    counts.room_over = room;
    while (!frozen && counts.room_over > 0 && fifo.earliest_write(counts.room_over - 1) > not_before(inner.writer))
        --counts.room_over;
    pen.put(FifoCounts::words, [&counts](StateWord* to) { counts.put(to); });
    for (std::uint64_t i = counts.tokens_over; i < counts.tokens; ++i)
        pen.put_time(fifo.earliest_read(i));
    for (std::uint64_t i = counts.room_over; i < room; ++i)
        pen.put_time(fifo.earliest_write(i));
}

void RelativeState::restore(StateView state, Cycles driver_time) {
    StateWord const* next = state.words;
    for (unsigned m = 0; m < group_->members().size(); ++m)
        next = restore_process(m, driver_time, next);
    for (Group::Inner const& inner : group_->fifos())
        next = restore_fifo(inner, driver_time, next);
}

StateWord const* RelativeState::restore_process(unsigned member, Cycles base, StateWord const* words) {
    ProcessTiming& p = process(member);
    p.time_ = base + static_cast<Cycles>(std::int64_t{*words++});
    ProcessFlags const flags = ProcessFlags::of(words);
    words += ProcessFlags::words;
    p.in_loop_ = flags.loop != 0;
    if (p.in_loop_)
        p.current_loop_ = flags.loop - 1;
    p.iterations_ = flags.begun;
    outlooks_[member] = {flags.next_ports, flags.frozen};
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
    for (std::size_t i = flags.left; i > 0; --i)
        p.log_.put_back(Operation(code_of(words + words_of_operation * (i - 1))));
    return words + words_of_operation * flags.left;
}

StateWord const* RelativeState::restore_fifo(Group::Inner const& inner, Cycles base, StateWord const* words) {
    FifoTiming& fifo = *inner.fifo;
    FifoCounts const counts = FifoCounts::of(words);
    words += FifoCounts::words;
    fifo.writes_ = fifo.reads_ + counts.tokens;
    std::uint64_t const room = fifo.known_writes();
    std::uint64_t const first_room = fifo.writes_ - fifo.room_;
    auto const readable_from = [&fifo](std::uint64_t i) -> Cycles& {
        return fifo.readable_from_[(fifo.reads_ + i) & fifo.index_mask_];
    };
    auto const free_from = [&fifo, first_room](std::uint64_t i) -> Cycles& {
        return fifo.free_from_[(first_room + i) & fifo.index_mask_];
    };
    for (std::uint64_t i = 0; i < counts.tokens_over; ++i)
        readable_from(i) = not_before(inner.reader);
    for (std::uint64_t i = 0; i < counts.room_over; ++i)
        free_from(i) = not_before(inner.writer);
    for (std::uint64_t i = counts.tokens_over; i < counts.tokens; ++i)
        readable_from(i) = base + static_cast<Cycles>(std::int64_t{*words++});
    for (std::uint64_t i = counts.room_over; i < room; ++i)
        free_from(i) = base + static_cast<Cycles>(std::int64_t{*words++});
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

std::uint32_t RelativeState::blocks_of(ProcessTiming const& process) {
    std::uint32_t blocks = 0;
    for (LoopShape const& loop : process.loops())
        blocks += blocks_of(loop);
    return blocks;
}

std::uint32_t RelativeState::blocks() const {
    auto blocks = static_cast<std::uint32_t>(group_->fifos().size());
    for (Group::Member const& member : group_->members())
        blocks += blocks_of(*member.process);
    return blocks;
}

void RelativeState::enter(FigureTotals const& figures) {
    auto next = figures.begin();
    for (Group::Member const& member : group_->members())
        next = enter(*member.process, next);
    for (Group::Inner const& inner : group_->fifos()) {
        auto const [tokens, full_stalls, empty_stalls] = next->sums;
        inner.fifo->passed_ += tokens;
        inner.fifo->full_stall_cycles_ += full_stalls;
        process(inner.writer).full_stall_cycles_ += full_stalls;
        inner.fifo->empty_stall_cycles_ += empty_stalls;
        process(inner.reader).empty_stall_cycles_ += empty_stalls;
        inner.fifo->max_occupancy_ = std::max(inner.fifo->max_occupancy_, next->largest);
        ++next;
    }
}

/// Returns what is behind its loops' figures.
FigureTotals::const_iterator RelativeState::enter(ProcessTiming& process, FigureTotals::const_iterator figures) {
    for (unsigned i = 0; i < process.loops_.size(); ++i) {
        LoopCounters& loop = process.loop_counters_[i];
        loop.entries += figures->sums[0];
        loop.iterations += figures->sums[1];
        ++figures;
        if (blocks_of(process.loops_[i]) == 1)
            continue;
        loop.recurrence_beyond_end += figures->sums[0];
        loop.port_conflict_beyond_end += figures->sums[1];
        ++figures;
    }
    return figures;
}

}  // namespace faster::timing
