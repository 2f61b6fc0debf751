#include "dataflow/lookup/relative_state.hpp"

#include <algorithm>
#include <limits>

namespace dataflow::timing {

Ports::Number RelativeState::next_ports(unsigned member) const {
    ProcessTiming const& p = process(member);
    return p.log_.exhausted() ? outlooks_[member].next_ports
                              : p.log().front().ports() & ~group_->members()[member].fed_ports;
}

void RelativeState::charge(unsigned member, unsigned port, Cycles cycles) {
    ProcessTiming& p = process(member);
    p.fifo(port).add_stall(p.writes(port), cycles);
    (p.writes(port) ? p.figures_.full_stall_cycles : p.figures_.empty_stall_cycles) += cycles;
}

void RelativeState::unpark(unsigned member, unsigned port, Cycles arrival, Cycles since) {
    ProcessTiming& p = process(member);
    if (p.flushes()) {  // its bubbles are over, whatever comes
        p.charged_until_ = port != no_port ? p.state_.time : ProcessTiming::never;
        p.arrival_ = arrival;
        return;
    }
    if (port != no_port) {
        charge(member, port, since - p.state_.time);  // in two's complement: what was charged ahead is taken back
        // What the step has found already was there when the waiting began; the state only knows that it is there now.
        std::uint32_t const before = (1U << port) - 1U;
        for (std::uint32_t mask = next_ports(member) & before; mask != 0; mask &= mask - 1)
            make_legal(member, static_cast<unsigned>(__builtin_ctz(mask)), since);
        p.charged_until_ = since;
        p.arrival_ = arrival;
    }
    p.state_.time = since;
}

void RelativeState::make_legal(unsigned member, unsigned port, Cycles from) {
    Cycles& earliest = (*process(member).ports_[port].end.consumes)[0];
    earliest = std::min(earliest, from);
}

bool RelativeState::save(StatePage& page, std::uint32_t with_logs) const {
    ProcessTiming const& driver = process(0);
    PipelinePosition const& pipeline = driver.state_.pipeline;
    if (driver.in_loop() && !driver.plan_->aligned && (pipeline.open || pipeline.gap_left > 0))
        return false;
    page.start(static_cast<std::int64_t>(driver.local_time()), most_words());
    for (unsigned m = 0; m < group_->members().size(); ++m) {
        ProcessFlags flags;
        flags.next_ports = outlooks_[m].next_ports;
        flags.frozen = outlooks_[m].frozen;
        save_process(process(m).rules(), flags, m > 0 && ((with_logs >> m) & 1U) != 0, page);
    }
    for (Group::Inner const& inner : group_->fifos()) {
        auto const reads_from = static_cast<std::int64_t>(process(inner.reader).not_before());
        auto const writes_from = static_cast<std::int64_t>(process(inner.writer).not_before());
        // Where a frozen writer finds room is told elsewhere.
        save_fifo(inner.fifo->rules_, reads_from,
                  outlooks_[inner.writer].frozen ? std::numeric_limits<std::int64_t>::max() : writes_from, page);
    }
    return page.reach() <= furthest_apart;
}

std::size_t RelativeState::most_words() const {
    std::size_t words = 0;
    for (Group::Member const& member : group_->members()) {
        words += 1 + ProcessFlags::words + words_of_operation * member.process->log().pending();
        if (member.process->flushes())
            words += words_of(member.process->state_.flushing);
        for (LoopPlan const& plan : member.process->shape()->plans)
            words += plan.longest_lag;
    }
    for (Group::Inner const& inner : group_->fifos())
        words += FifoCounts::words + inner.fifo->rules_.room;
    return words;
}

void RelativeState::clear_logs(std::uint32_t members) {
    for (unsigned m = 0; m < group_->members().size(); ++m)
        if (((members >> m) & 1U) != 0)
            process(m).log_.clear();
}

void RelativeState::restore(StateView state, Cycles driver_time) {
    StateWord const* next = state.words;
    for (unsigned m = 0; m < group_->members().size(); ++m) {
        ProcessFlags flags;
        next = load_process(process(m).rules(), driver_time, next, flags);
        outlooks_[m] = {flags.next_ports, flags.frozen};
    }
    for (Group::Inner const& inner : group_->fifos())
        next = load_fifo(inner.fifo->rules_, driver_time, process(inner.reader).not_before(),
                         process(inner.writer).not_before(), next);
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
    fifo.rules_.free[i] = cycle;
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
        process(inner.writer).figures_.full_stall_cycles += full_stalls;
        inner.fifo->empty_stall_cycles_ += empty_stalls;
        process(inner.reader).figures_.empty_stall_cycles += empty_stalls;
        inner.fifo->max_occupancy_ = std::max(inner.fifo->max_occupancy_, next->largest);
        ++next;
    }
}

/// Returns what is behind its loops' figures.
FigureTotals::const_iterator RelativeState::enter(ProcessTiming& process, FigureTotals::const_iterator figures) {
    for (unsigned i = 0; i < process.loops().size(); ++i) {
        LoopCounters& loop = process.figures_.loops[i];
        loop.entries += figures->sums[0];
        loop.iterations += figures->sums[1];
        ++figures;
        if (blocks_of(process.loops()[i]) == 1)
            continue;
        loop.recurrence_beyond_end += figures->sums[0];
        loop.port_conflict_beyond_end += figures->sums[1];
        ++figures;
    }
    return figures;
}

}  // namespace dataflow::timing
