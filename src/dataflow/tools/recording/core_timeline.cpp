#include "dataflow/tools/recording/core_timeline.hpp"

#include <algorithm>

#include "dataflow/tools/recording/event_merge.hpp"
#include "dataflow/tools/recording/largest_in_stretches.hpp"

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
          occupancy_(machine_.fifos.size(), {0, {core.from, core.to, grain.occupancy_bucket}}) {
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
        LargestInStretches largest;
    };

    bool is_in_window(Cycles cycle) const { return cycle >= core_.from && cycle <= core_.to; }
    void close(Open& open, Cycles end);
    TimelineSpan::Kind kind_of_stall(std::size_t module, std::size_t item) const;
    void take_stall(std::size_t module, Event const& event);
    void take_sample(Event const& event);
    void change_occupancy(std::size_t fifo, Cycles cycle, int change);

    RecordedCore const& core_;
    Machine const& machine_;
    TimelineGrain grain_;
    CoreTimeline timeline_;
    std::vector<std::size_t> ended_;  // samples: without a cycle, one ends in the cycle before it begins
    std::vector<Open> loops_;         // by process
    std::vector<Open> stalls_;        // by process
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
        case Kind::begin:
        case Kind::end:
            take_sample(event);
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

void TimelineMaker::take_sample(Event const& event) {
    auto const sample = static_cast<std::size_t>(event.value);
    if (!is_in_window(event.cycle))
        return;
    if (event.kind == Kind::begin) {
        bool const is_over = std::find(ended_.begin(), ended_.end(), sample) != ended_.end();
        timeline_.samples.push_back({sample, event.cycle, is_over ? event.cycle : core_.to + 1, is_over});
        return;
    }
    ended_.push_back(sample);
    for (CoreTimeline::Sample& begun : timeline_.samples)
        if (begun.sample == sample)
            begun = {sample, begun.begin, event.cycle + 1, true};
}

/// What is written and read in the same cycle is never there at its end.
void TimelineMaker::change_occupancy(std::size_t fifo, Cycles cycle, int change) {
    Occupancy& now = occupancy_[fifo];
    now.tokens = change > 0 ? now.tokens + 1 : now.tokens - 1;
    now.largest.take(cycle, std::min(now.tokens, core_.fifos[fifo].capacity));
}

CoreTimeline TimelineMaker::finish() {
    for (std::size_t module = 0; module < loops_.size(); ++module) {
        close(stalls_[module], stalls_[module].span.end);
        close(loops_[module], core_.to + 1);
    }
    for (std::size_t const fifo : fifos_of(machine_))
        timeline_.occupancy[fifo] = occupancy_[fifo].largest.finish();
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
