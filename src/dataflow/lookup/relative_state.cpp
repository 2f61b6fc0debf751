#include "dataflow/lookup/relative_state.hpp"

#include <algorithm>

#include "dataflow/base/each_bit.hpp"

namespace dataflow::timing {

Ports::Number RelativeState::next_ports(unsigned member) const {
    OperationLog const& log = process(member).log();
    return log.exhausted() ? outlooks_[member].next_ports : log.front().ports() & ~group_->members()[member].fed_ports;
}

void RelativeState::charge(unsigned member, unsigned port, Cycles cycles) {
    ProcessTiming& p = process(member);
    ProcessFigures& figures = view(member).figures();
    p.fifo(port).add_stall(p.writes(port), cycles);
    (p.writes(port) ? figures.full_stall_cycles : figures.empty_stall_cycles) += cycles;
}

void RelativeState::unpark(unsigned member, unsigned port, Cycles arrival, Cycles since,
                           std::vector<EarlierWait> const& waits) {
    ProcessTiming::View const p = view(member);
    if (process(member).flushes()) {  // its bubbles are over, whatever comes
        port != no_port ? p.waits_since(arrival) : p.arrived(arrival);
        return;
    }
    // What was charged ahead is taken back, in two's complement.
    if (port != no_port)
        charge(member, port, since - p.state().time);
    for (std::size_t i = 0; i < waits.size(); ++i)
        charge(member, waits[i].port, (i + 1 < waits.size() ? waits[i + 1].until : arrival) - waits[i].until);
    std::uint32_t const last = port != no_port ? (1U << port) - 1U : waits.empty() ? 0 : (2U << waits[0].port) - 1U;
    for_each_bit(next_ports(member) & last, [&](unsigned number) {
        auto const wait =
            std::find_if(waits.begin(), waits.end(), [&](EarlierWait const& w) { return w.port == number; });
        make_legal(member, number, wait != waits.end() ? wait->until : arrival);
    });
    p.state().time = arrival;
}

/// Where a state only knows that a port can be accessed now.
void RelativeState::make_legal(unsigned member, unsigned port, Cycles from) {
    auto const& end = view(member).port(port).end;
    if (end.known() > 0 && end.earliest() <= process(member).local_time())
        (*end.consumes)[0] = std::min((*end.consumes)[0], from);
}

bool RelativeState::save(StatePage& page, std::uint32_t with_logs) const {
    ProcessTiming const& driver = process(0);
    PipelinePosition const& pipeline = view(0).state().pipeline;
    if (driver.in_loop() && !view(0).plan().aligned && (pipeline.open || pipeline.gap_left > 0))
        return false;
    if (driver_leaves_group())
        return false;
    page.start(static_cast<std::int64_t>(driver.local_time()), most_words());
    for (unsigned m = 0; m < group_->members().size(); ++m) {
        ProcessFlags flags;
        flags.next_ports = outlooks_[m].next_ports;
        flags.frozen = outlooks_[m].frozen;
        save_process(view(m).rules(), flags, m > 0 && ((with_logs >> m) & 1U) != 0, page);
    }
    for (Group::Inner const& inner : group_->fifos()) {
        auto const reads_from = static_cast<std::int64_t>(process(inner.reader).not_before());
        auto const writes_from = static_cast<std::int64_t>(process(inner.writer).not_before());
        save_fifo(FifoTiming::View(*inner.fifo).rules(), reads_from, writes_from, outlooks_[inner.writer].frozen, page);
    }
    return page.reach() <= furthest_apart;
}

/// What its last iterations have yet to access, another process shares.
bool RelativeState::driver_leaves_group() const {
    ProcessTiming::View const driver = view(0);
    bool leaves = false;
    for (std::uint64_t lag = 1; driver.rules().has_delay_line() && lag <= driver.plan().longest_lag; ++lag)
        leaves = leaves || (driver.state().delayed(lag) & ~group_->members().front().inner_ports) != 0;
    return leaves;
}

std::size_t RelativeState::most_words() const {
    std::size_t words = 0;
    for (Group::Member const& member : group_->members())
        words += most_words_of(ProcessTiming::View(*member.process).rules(), *member.process->shape());
    for (Group::Inner const& inner : group_->fifos())
        words += FifoCounts::words + FifoTiming::View(*inner.fifo).rules().room;
    return words;
}

void RelativeState::clear_logs(std::uint32_t members) {
    for (unsigned m = 0; m < group_->members().size(); ++m)
        if (((members >> m) & 1U) != 0)
            process(m).log().clear();
}

void RelativeState::restore(StateView state, Cycles driver_time) {
    StateWord const* next = state.words;
    for (unsigned m = 0; m < group_->members().size(); ++m) {
        ProcessFlags flags;
        next = load_process(view(m).rules(), driver_time, next, flags);
        outlooks_[m] = {flags.next_ports, flags.frozen};
    }
    for (Group::Inner const& inner : group_->fifos())
        next = load_fifo(FifoTiming::View(*inner.fifo).rules(), driver_time, process(inner.reader).not_before(),
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
    FifoTiming::View(fifo).rules().free[i] = cycle;
}

namespace {
/// As the bench counts it: a first call has begun before anything is worked out there.
bool awaits_setups_or_calls(ProcessShape const& shape) { return shape.sets_up_ahead || shape.call_start.is_in_turn; }
}  // namespace

std::uint32_t RelativeState::blocks_of(ProcessTiming const& process) {
    std::uint32_t blocks = 0;
    for (LoopShape const& loop : process.loops())
        blocks += blocks_of(loop);
    return blocks + (awaits_setups_or_calls(*process.shape()) ? 1 : 0);
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
        FifoTiming::View const fifo(*inner.fifo);
        fifo.pass(tokens);
        inner.fifo->add_stall(true, full_stalls);
        view(inner.writer).figures().full_stall_cycles += full_stalls;
        inner.fifo->add_stall(false, empty_stalls);
        view(inner.reader).figures().empty_stall_cycles += empty_stalls;
        fifo.max_occupancy() = std::max(fifo.max_occupancy(), next->largest);
        ++next;
    }
}

/// Returns what is behind its figures.
FigureTotals::const_iterator RelativeState::enter(ProcessTiming& process, FigureTotals::const_iterator figures) {
    for (unsigned i = 0; i < process.loops().size(); ++i) {
        LoopCounters& loop = ProcessTiming::View(process).figures().loops[i];
        loop.entries += figures->sums[0];
        loop.iterations += figures->sums[1];
        loop.interlock_cycles += figures->sums[2];
        ++figures;
        if (blocks_of(process.loops()[i]) == 1)
            continue;
        loop.recurrence_beyond_end += figures->sums[0];
        loop.port_conflict_beyond_end += figures->sums[1];
        ++figures;
    }
    if (awaits_setups_or_calls(*process.shape()))
        ProcessTiming::View(process).figures().awaited_setup_cycles += (figures++)->sums[0];
    return figures;
}

}  // namespace dataflow::timing
