#include "dataflow/tools/recording/core_timeline.hpp"

#include <algorithm>

#include "dataflow/tools/recording/event_merge.hpp"

namespace dataflow::recording {

namespace {

using Kind = Event::Kind;

class TimelineMaker {
  public:
    TimelineMaker(RecordedCore const& core, TimelineGrain const& grain)
        : core_(core),
          machine_(*core.machine),
          grain_(grain),
          loops_(machine_.processes.size()),
          stalls_(machine_.processes.size()),
          occupancy_(machine_.fifos.size()) {
        timeline_.core = core.core;
        timeline_.machine = core.machine;
        timeline_.occupancy.resize(machine_.fifos.size());
    }

    void take(CoreEvent const& event);
    CoreTimeline finish();

  private:
    struct Open {
        TimelineSpan span;
        bool is_open = false;
    };
    struct Occupancy {
        std::uint64_t tokens = 0;
        Cycles cycle = 0;           ///< from whose end on they are there
        Cycles bucket = 0;          ///< at hand
        std::uint64_t largest = 0;  ///< at the end of any cycle of the bucket before that
    };

    bool is_in_window(Cycles cycle) const { return cycle >= core_.from && cycle <= core_.to; }
    void close(Open& open, Cycles end);
    TimelineSpan::Kind kind_of_stall(std::size_t module, std::size_t item) const;
    void take_stall(std::size_t module, Event const& event);
    void take_stamp(std::size_t module, Event const& event);
    void change_occupancy(std::size_t fifo, Cycles cycle, int change);
    void keep_occupancy(Occupancy& now) const;
    void come_to(std::size_t fifo, Cycles cycle);
    void put_occupancy(std::size_t fifo, Cycles cycle, std::uint64_t tokens);

    RecordedCore const& core_;
    Machine const& machine_;
    TimelineGrain grain_;
    CoreTimeline timeline_;
    std::vector<Open> loops_;   // by process
    std::vector<Open> stalls_;  // by process
    std::vector<Occupancy> occupancy_;
};

/// Adds the part of a span that lies in the window.
void TimelineMaker::close(Open& open, Cycles end) {
    if (!open.is_open)
        return;
    open.is_open = false;
    open.span.end = std::min(end, core_.to + 1);
    open.span.begin = std::max(open.span.begin, core_.from);
    if (open.span.begin < open.span.end)
        timeline_.spans.push_back(open.span);
}

void TimelineMaker::take(CoreEvent const& core_event) {
    Event const& event = core_event.event;
    std::size_t const module = core_event.process;
    switch (event.kind) {
        case Kind::enter:
            close(stalls_[module], std::min(stalls_[module].span.end, event.cycle));
            loops_[module] = {{module, TimelineSpan::Kind::loop, event.item, event.cycle, 0, 0}, true};
            break;
        case Kind::leave:
            close(stalls_[module], std::min(stalls_[module].span.end, event.cycle));
            close(loops_[module], event.cycle);
            break;
        case Kind::iterate:
            loops_[module].span.count += is_in_window(event.cycle) ? 1U : 0U;
            break;
        case Kind::stall:
            take_stall(module, event);
            break;
        case Kind::read:
            change_occupancy(event.item, event.cycle, -1);
            break;
        case Kind::write:
            change_occupancy(event.item, event.cycle, 1);
            break;
        case Kind::stamp:
            take_stamp(module, event);
            break;
        case Kind::resume:
        case Kind::field:
        case Kind::at_iteration:
            break;
    }
}

TimelineSpan::Kind TimelineMaker::kind_of_stall(std::size_t module, std::size_t item) const {
    if (item >= machine_.fifos.size())
        return TimelineSpan::Kind::memory_stall;
    return machine_.fifos[item].writer == module ? TimelineSpan::Kind::full_stall : TimelineSpan::Kind::empty_stall;
}

void TimelineMaker::take_stall(std::size_t module, Event const& event) {
    Open& open = stalls_[module];
    auto const until = static_cast<Cycles>(event.value);
    if (until <= core_.from)
        return;
    bool const goes_on =
        open.is_open && open.span.item == event.item && event.cycle <= open.span.end + grain_.stall_gap;
    if (!goes_on) {
        close(open, open.span.end);
        open = {{module, kind_of_stall(module, event.item), event.item, event.cycle, 0, 0}, true};
    }
    open.span.end = until;
    Cycles const begin = std::max(event.cycle, core_.from);
    Cycles const end = std::min(until, core_.to + 1);
    open.span.count += begin < end ? end - begin : 0;
}

void TimelineMaker::take_stamp(std::size_t module, Event const& event) {
    auto const sample = static_cast<std::size_t>(event.value);
    if (!is_in_window(event.cycle))
        return;
    if (module == machine_.begins)
        timeline_.samples.push_back({sample, event.cycle, core_.to + 1, false});
    if (module != machine_.ends)
        return;
    for (CoreTimeline::Sample& begun : timeline_.samples)
        if (begun.sample == sample)
            begun = {sample, begun.begin, event.cycle + 1, true};
}

void TimelineMaker::change_occupancy(std::size_t fifo, Cycles cycle, int change) {
    Occupancy& now = occupancy_[fifo];
    if (cycle > core_.to)  // decoupled goes beyond the end of the run
        return;
    if (cycle != now.cycle)
        come_to(fifo, cycle);
    now.tokens = change > 0 ? now.tokens + 1 : now.tokens - 1;
}

/// What is written and read in the same cycle is never there at its end.
void TimelineMaker::keep_occupancy(Occupancy& now) const {
    now.largest = now.cycle < core_.from ? now.tokens : std::max(now.largest, now.tokens);
}

void TimelineMaker::come_to(std::size_t fifo, Cycles cycle) {
    Occupancy& now = occupancy_[fifo];
    Cycles const grain = grain_.occupancy_bucket, bucket = cycle / grain;
    keep_occupancy(now);
    if (bucket != now.bucket) {
        put_occupancy(fifo, now.bucket * grain, now.largest);
        if (bucket > now.bucket + 1)
            put_occupancy(fifo, (now.bucket + 1) * grain, now.tokens);
        now.bucket = bucket;
        now.largest = cycle > bucket * grain ? now.tokens : 0;
    }
    now.cycle = cycle;
}

void TimelineMaker::put_occupancy(std::size_t fifo, Cycles cycle, std::uint64_t tokens) {
    std::vector<OccupancyPoint>& points = timeline_.occupancy[fifo];
    std::uint64_t const shown = std::min(tokens, core_.fifos[fifo].capacity);
    if (cycle > core_.to)
        return;
    Cycles const at = std::max(cycle, core_.from);
    if (!points.empty() && points.back().cycle == at)
        points.back().tokens = shown;
    else if (points.empty() || points.back().tokens != shown)
        points.push_back({at, shown});
}

CoreTimeline TimelineMaker::finish() {
    for (std::size_t module = 0; module < loops_.size(); ++module) {
        close(stalls_[module], stalls_[module].span.end);
        close(loops_[module], core_.to + 1);
    }
    for (std::size_t const fifo : fifos_of(machine_)) {
        Occupancy& last = occupancy_[fifo];
        keep_occupancy(last);
        put_occupancy(fifo, last.bucket * grain_.occupancy_bucket, last.largest);
        put_occupancy(fifo, (last.bucket + 1) * grain_.occupancy_bucket, last.tokens);
    }
    std::stable_sort(timeline_.spans.begin(), timeline_.spans.end(), outermost_first);
    return std::move(timeline_);
}

}  // namespace

CoreTimeline make_timeline(RecordedCore const& core, TimelineGrain const& grain) {
    TimelineMaker maker(core, grain);
    for_each_event({{0, core.spools}}, [&maker](CoreEvent const& event) { maker.take(event); });
    return maker.finish();
}

SampleTimeline sample_timeline(RecordedCore const& core, std::size_t sample) {
    TimelineGrain exact;
    exact.occupancy_bucket = 1;
    CoreTimeline timeline = make_timeline(core, exact);
    return {core.core, sample, core.from, core.to + 1, std::move(timeline.spans), std::move(timeline.occupancy)};
}

}  // namespace dataflow::recording
