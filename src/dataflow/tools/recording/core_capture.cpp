#include "dataflow/tools/recording/core_capture.hpp"

#include <algorithm>

namespace dataflow::recording {

using Kind = Event::Kind;
using timing::ProcessTiming;

CoreCapture::CoreCapture(Machine const& machine, timing::CoreTiming& core, std::vector<TokenTap> const& taps,
                         CoreShare share, std::uint64_t tokens_in_use, Spools& spools)
    : machine_(machine),
      core_(core),
      taps_(taps),
      share_(share),
      tokens_in_use_(tokens_in_use),
      spools_(spools),
      late_(core.processes().size()) {
    number_parts();
    take_down_state();
    for (std::size_t i = 0; i < core.processes().size(); ++i)
        core.process(i).set_observer(this);
}

/// A process numbers its ports and loops from 0 on.
void CoreCapture::number_parts() {
    writers_.resize(machine_.fifos.size());
    for (ProcessTiming const& process : core_.processes()) {
        std::vector<std::uint32_t>& fifos = fifos_at_.emplace_back();
        for (unsigned port = 0; port < process.port_count(); ++port) {
            fifos.push_back(static_cast<std::uint32_t>(core_.number_of(process.fifo(port))));
            if (process.writes(port) && !process.fifo(port).is_stream())
                writers_[fifos.back()] = process.index();
        }
        std::vector<std::uint32_t>& loops = loops_at_.emplace_back();
        for (timing::LoopShape const& loop : process.loops())
            loops.push_back(static_cast<std::uint32_t>(machine_.loop(process.index(), loop.name)));
    }
}

void CoreCapture::take_down_state() {
    for (ProcessTiming const& process : core_.processes()) {
        take_down_past(process);
        take_down_loop(process);
        take_down_samples(process);
    }
}

/// Of stamps, the last, and those before it that are still to come: a loop that rewinds tells them ahead.
void CoreCapture::take_down_samples(ProcessTiming const& process) {
    std::vector<Cycles> const& stamps = process.stamps();
    if (stamps.empty() && machine_.begins == machine_.ends && process.index() == machine_.begins)
        put_sample(Event::Kind::begin, 0, 0);
    std::size_t stamp = stamps.size();
    while (stamp > 0 && (stamp == stamps.size() || stamps[stamp - 1] >= process.local_time()))
        --stamp;
    for (; stamp < stamps.size(); ++stamp)
        put_stamp(process, stamp);
}

/// The iteration that began last can be seen until a loop is entered again.
void CoreCapture::take_down_loop(ProcessTiming const& process) {
    if (process.in_loop())
        entered_loop(process, process.current_loop(), process.local_time());
    std::uint64_t const begun = process.iterations() + (process.is_in_iteration() ? 1U : 0U);
    if (begun == 0)
        return;
    put(process, event_at(process.local_time(), Kind::at_iteration, 0, begun - 1));
}

/// Tokens inside are told as writes in the cycles in which they were written. The last ones read may still be in use:
/// they are told as written and read before, the read a cycle later if events of one cycle come reader first.
std::vector<CoreCapture::PastEvent> CoreCapture::past_accesses(ProcessTiming const& process) const {
    std::vector<PastEvent> accesses;
    for (unsigned port = 0; port < process.port_count(); ++port) {
        timing::FifoTiming const& fifo = process.fifo(port);
        if (fifo.is_stream())
            continue;
        std::uint32_t const number = fifo_at(process, port);
        bool const writes = process.writes(port);
        Kind const kind = writes ? Kind::write : Kind::read;
        Cycles const latency = fifo.shape().read_latency + fifo.shape().issue_latency;
        Cycles const read_at = fifo.shape().issue_latency + (writers_[number] > process.index() ? 1 : 0);
        for (std::uint64_t i = std::min(tokens_in_use_, fifo.reads()); i > 0; --i)
            accesses.push_back({writes ? 0 : read_at, kind, number, fifo.reads() - i});
        for (std::uint64_t i = 0; writes && i < fifo.known_reads(); ++i)
            accesses.push_back({fifo.earliest_read(i) - latency, kind, number, fifo.reads() + i});
    }
    return accesses;
}

/// Tokens in the order of their cycles.
void CoreCapture::take_down_past(ProcessTiming const& process) {
    std::vector<PastEvent> events = past_accesses(process);
    std::stable_sort(events.begin(), events.end(),
                     [](PastEvent const& a, PastEvent const& b) { return a.cycle < b.cycle; });
    for (PastEvent const& event : events)
        if (event.kind == Kind::read)
            put_read(process, event.fifo, event.cycle);
        else if (process.flushes() && event.cycle >= process.local_time())
            put_late(process, event.fifo, event.number, process.due(event.cycle), event.cycle);
        else
            put_write(process, event.fifo, event.number, event.cycle);
}

void CoreCapture::put_read(ProcessTiming const& process, std::uint32_t fifo, Cycles cycle) {
    put(process, event_at(cycle, Kind::read, fifo));
}

/// Events of a process are in the order of their cycles.
void CoreCapture::put(ProcessTiming const& process, Event const& event) {
    tell_late(process.index(), event.cycle);
    spool(process.index(), event);
}

void CoreCapture::spool(std::size_t process, Event const& event) {
    if (event.cycle <= last_)
        spools_.processes[process].put(event);
}

/// What was told ahead of time and happens before a cycle, or in it.
void CoreCapture::tell_late(std::size_t process, Cycles until) {
    std::deque<Event>& late = late_[process];
    for (; !late.empty() && late.front().cycle <= until; late.pop_front())
        spool(process, late.front());
}

void CoreCapture::finish() {
    for (std::size_t process = 0; process < late_.size(); ++process)
        tell_late(process, ~Cycles{0});
}

void CoreCapture::entered_loop(ProcessTiming const& process, unsigned loop, Cycles cycle) {
    put(process, event_at(cycle, Kind::enter, loops_at_[process.index()][loop]));
}

void CoreCapture::left_loop(ProcessTiming const& process, Cycles cycle) { put(process, event_at(cycle, Kind::leave)); }

void CoreCapture::iterated(ProcessTiming const& process, Cycles cycle, std::uint64_t first, std::uint64_t count,
                           Cycles stride) {
    Event event = event_at(cycle, Kind::iterate, 0, first);
    event.count = count;
    event.stride = static_cast<std::uint32_t>(stride);
    put(process, event);
}

/// What happens in a flushing pipeline during a stall parts it.
void CoreCapture::stalled(ProcessTiming const& process, unsigned port, Cycles from, Cycles until) {
    std::deque<Event>& late = late_[process.index()];
    while (!late.empty() && late.front().cycle < until) {
        Event const next = late.front();
        Cycles const goes_on = next.kind == Kind::stall ? static_cast<Cycles>(next.value) : next.cycle;
        if (next.cycle > from)
            put_stall(process, port, from, next.cycle);
        tell_late(process.index(), goes_on);
        from = std::max(from, goes_on);
    }
    if (from < until)
        put_stall(process, port, from, until);
}

void CoreCapture::put_stall(ProcessTiming const& process, unsigned port, Cycles from, Cycles until) {
    spool(process.index(), event_at(from, Kind::stall, fifo_at(process, port), until));
}

void CoreCapture::accessed(ProcessTiming const& process, timing::Ports ports, Cycles cycle) {
    ports.each([&](unsigned port) {
        if (process.fifo(port).is_stream())
            return;
        if (process.writes(port))
            put_write(process, fifo_at(process, port), process.fifo(port).writes(), cycle);
        else
            put_read(process, fifo_at(process, port), cycle);
    });
}

void CoreCapture::put_write(ProcessTiming const& process, std::uint32_t fifo, std::uint64_t number, Cycles cycle) {
    for (Event const& event : write_of(fifo, number, cycle))
        put(process, event);
}

/// A token with its fields; of a FIFO without any, 0.
std::vector<Event> CoreCapture::write_of(std::uint32_t fifo, std::uint64_t number, Cycles cycle) const {
    std::size_t const fields = taps_[fifo].layout().size();
    std::int64_t const none = 0;
    std::int64_t const* const values = fields > 0 ? taps_[fifo].token(number) : &none;
    std::vector<Event> events(std::max<std::size_t>(fields, 1));
    for (std::size_t i = 0; i < events.size(); ++i)
        events[i] = event_at(cycle, i == 0 ? Kind::write : Kind::field, fifo, values[i]);
    return events;
}

void CoreCapture::let_out(ProcessTiming const& process, unsigned port, Cycles due, Cycles cycle) {
    put_late(process, fifo_at(process, port), process.fifo(port).writes(), due, cycle);
}

void CoreCapture::put_late(ProcessTiming const& process, std::uint32_t fifo, std::uint64_t number, Cycles due,
                           Cycles cycle) {
    std::deque<Event>& late = late_[process.index()];
    if (cycle > due)
        late.push_back(event_at(due, Kind::stall, fifo, cycle));
    std::vector<Event> const token = write_of(fifo, number, cycle);
    late.insert(late.end(), token.begin(), token.end());
}

void CoreCapture::stamped(ProcessTiming const& process, Cycles /*cycle*/) {
    put_stamp(process, process.stamps().size() - 1);
}

void CoreCapture::put_stamp(ProcessTiming const& process, std::size_t stamp) {
    bool const ends = process.index() == machine_.ends;
    if (ends)
        put_sample(Kind::end, stamp, process.stamps()[stamp]);
    if (process.index() != machine_.begins)
        return;
    if (ends)
        put_sample(Kind::begin, stamp + 1, process.next_calls()[stamp]);
    else
        put_sample(Kind::begin, stamp, process.stamps()[stamp]);
}

/// After its last sample, a process begins none.
void CoreCapture::put_sample(Event::Kind kind, std::size_t sample, Cycles cycle) {
    if (sample >= share_.count || cycle > last_)
        return;
    (kind == Kind::begin ? spools_.begins : spools_.ends).put(event_at(cycle, kind, 0, share_.first + sample));
}

}  // namespace dataflow::recording
