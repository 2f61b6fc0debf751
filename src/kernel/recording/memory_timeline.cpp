#include "kernel/recording/memory_timeline.hpp"

#include <algorithm>

#include "kernel/recording/memory_changes.hpp"

namespace faster::recording {

namespace {

/// Values over time: the largest in each stretch of so many cycles.
class LargestInStretches {
  public:
    LargestInStretches(Cycles from, Cycles stretch) : from_(from), stretch_(stretch) {}

    void take(Cycles cycle, std::uint64_t value) {
        Cycles const at = from_ + (std::max(cycle, from_) - from_) / stretch_ * stretch_;
        if (at > at_) {
            put(at_, largest_);
            put(at_ + stretch_, value_);
            at_ = at;
            largest_ = value_;
        }
        value_ = value;
        largest_ = cycle < from_ ? value : std::max(largest_, value);
    }
    std::vector<OccupancyPoint> finish() {
        put(at_, largest_);
        put(at_ + stretch_, value_);
        return std::move(points_);
    }

  private:
    void put(Cycles cycle, std::uint64_t value) {
        if (points_.empty() || points_.back().tokens != value)
            points_.push_back({cycle, value});
    }

    Cycles from_;
    Cycles stretch_;
    Cycles at_ = from_;
    std::uint64_t value_ = 0;
    std::uint64_t largest_ = 0;
    std::vector<OccupancyPoint> points_;
};

class Maker {
  public:
    Maker(RecordedMemory const& memory, Cycles from, Cycles to, Cycles grain)
        : changes_(memory),
          from_(from),
          to_(to),
          grain_(grain),
          timeline_{std::vector<MemoryTimeline::Port>(memory.shape.ports), {}},
          waiting_(memory.shape.ports, {from, grain}),
          queue_(from, grain),
          before_(changes_.ports()) {}

    MemoryTimeline make() {
        while (changes_.next_cycle() <= to_) {
            Cycles const cycle = changes_.next_cycle();
            std::size_t const port = changes_.go_on();
            port < before_.size() ? take(port, cycle) : queue_.take(cycle, changes_.controller().queue);
        }
        for (std::size_t port = 0; port < before_.size(); ++port) {
            if (before_[port].reads > 0)
                busy_until(port, to_ + 1);
            timeline_.ports[port].waiting = waiting_[port].finish();
        }
        timeline_.queue = queue_.finish();
        return std::move(timeline_);
    }

  private:
    void take(std::size_t number, Cycles cycle) {
        MemoryChanges::Port const& port = changes_.ports()[number];
        waiting_[number].take(cycle, port.waiting);
        if (before_[number].reads > 0)
            busy_until(number, cycle);
        if (port.reads > 0)
            busy_from(number, cycle);
        if (port.reads < before_[number].reads && cycle > from_)
            timeline_.ports[number].busy.back().bytes += port.bytes - before_[number].bytes;
        before_[number] = port;
    }
    void busy_from(std::size_t port, Cycles cycle) {
        std::vector<MemoryTimeline::Span>& busy = timeline_.ports[port].busy;
        Cycles const begin = std::max(cycle, from_);
        if (!busy.empty() && busy.back().end == busy.back().begin)
            busy.pop_back();  // was over before the first cycle
        if (busy.empty() || begin > busy.back().end + grain_)
            busy.push_back({begin, begin, 0});
    }
    void busy_until(std::size_t port, Cycles cycle) {
        MemoryTimeline::Span& last = timeline_.ports[port].busy.back();
        last.end = std::max(last.end, cycle);
    }

    MemoryChanges changes_;
    Cycles from_;
    Cycles to_;
    Cycles grain_;
    MemoryTimeline timeline_;
    std::vector<LargestInStretches> waiting_;
    LargestInStretches queue_;
    std::vector<MemoryChanges::Port> before_;
};

std::size_t size_of(MemoryTimeline const& timeline) {
    std::size_t size = timeline.queue.size();
    for (MemoryTimeline::Port const& port : timeline.ports)
        size += port.busy.size() + port.waiting.size();
    return size;
}

}  // namespace

MemoryTimeline make_memory_timeline(RecordedMemory const& memory, Cycles from, Cycles to, std::size_t most) {
    for (Cycles grain = 64;; grain *= 2) {
        MemoryTimeline timeline = Maker(memory, from, to, grain).make();
        if (size_of(timeline) <= most)
            return timeline;
    }
}

}  // namespace faster::recording
