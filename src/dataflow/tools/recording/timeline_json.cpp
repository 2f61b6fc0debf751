#include "dataflow/tools/recording/timeline_json.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "dataflow/base/files/json_file.hpp"
#include "dataflow/base/json.hpp"
#include "dataflow/tools/recording/largest_in_stretches.hpp"
#include "dataflow/tools/recording/memory_changes.hpp"

namespace dataflow::recording {

namespace {

class Maker {
  public:
    Maker(RecordedBursts const& memory, Cycles from, Cycles to, Cycles grain)
        : changes_(memory),
          from_(from),
          to_(to),
          grain_(grain),
          timeline_{std::vector<MemoryTimeline::Port>(memory.shape.ports), {}},
          waiting_(memory.shape.ports, {from, to, grain}),
          queue_(from, to, grain),
          before_(changes_.ports()) {}

    MemoryTimeline make() {
        while (changes_.next_cycle() <= to_) {
            Cycles const cycle = changes_.next_cycle();
            while (changes_.next_cycle() == cycle)
                if (std::size_t const port = changes_.go_on(); port < before_.size())
                    take(port, cycle);
            queue_.take(cycle, changes_.controller().queue);
            for (std::size_t port = 0; port < before_.size(); ++port)
                waiting_[port].take(cycle, changes_.ports()[port].waiting);
        }
        for (std::size_t port = 0; port < before_.size(); ++port) {
            if (before_[port].reads > 0)
                busy_until(port, to_ + 1);
            drop_empty(timeline_.ports[port].busy);
            timeline_.ports[port].waiting = waiting_[port].finish();
        }
        timeline_.queue = queue_.finish();
        return std::move(timeline_);
    }

  private:
    void take(std::size_t number, Cycles cycle) {
        MemoryChanges::Port const& port = changes_.ports()[number];
        if (before_[number].reads > 0)
            busy_until(number, cycle);
        if (port.reads > 0)
            busy_from(number, cycle);
        if (port.reads < before_[number].reads && cycle > from_)
            timeline_.ports[number].busy.back().bytes += port.bytes - before_[number].bytes;
        before_[number] = port;
    }
    /// The last, if it was over before the first cycle.
    static void drop_empty(std::vector<MemoryTimeline::Span>& busy) {
        if (!busy.empty() && busy.back().end == busy.back().begin)
            busy.pop_back();
    }
    void busy_from(std::size_t port, Cycles cycle) {
        std::vector<MemoryTimeline::Span>& busy = timeline_.ports[port].busy;
        Cycles const begin = std::max(cycle, from_);
        drop_empty(busy);
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

/// Tracks on which slices that overlap are side by side.
class Lanes {
  public:
    /// The first lane that is free from a cycle on. Slices come in the order of their begins.
    std::size_t take(Cycles begin, Cycles end) {
        auto const free =
            std::find_if(free_from_.begin(), free_from_.end(), [=](Cycles from) { return from <= begin; });
        auto const lane = static_cast<std::size_t>(free - free_from_.begin());
        if (free == free_from_.end())
            free_from_.push_back(end);
        else
            *free = end;
        return lane;
    }
    std::size_t count() const { return free_from_.size(); }

  private:
    std::vector<Cycles> free_from_;
};

class TimelineWriter {
  public:
    explicit TimelineWriter(double clock_mhz) : ns_per_cycle_(1e3 / clock_mhz) {}

    void add(CoreTimeline const& core) {
        process_ = core.core;
        name("process_name", 0, "core " + std::to_string(core.core));
        std::size_t const lanes = add_samples(core);
        for (std::size_t const module : modules_of(*core.machine))
            name("thread_name", lanes + module, core.machine->processes[module].name);
        for (TimelineSpan const& span : core.spans)
            add_span(core, lanes + span.module, span);
        for (std::size_t const fifo : fifos_of(*core.machine))
            add_counter(core.machine->fifos[fifo].name, "tokens", core.occupancy[fifo]);
        process_count_ = std::max(process_count_, core.core + 1);
    }

    /// Behind all cores.
    void add(MemoryTimeline const& memory) {
        process_ = process_count_;
        name("process_name", 0, "memory");
        for (std::size_t port = 0; port < memory.ports.size(); ++port) {
            name("thread_name", port, fmt::format("port {}", port));
            for (MemoryTimeline::Span const& span : memory.ports[port].busy)
                add_slice(port, "busy", "memory", span.begin, span.end,
                          fmt::format(R"({},"bytes":{})", cycles_of(span), span.bytes));
            add_counter(fmt::format("port {} waiting", port), "requests", memory.ports[port].waiting);
        }
        add_counter("controller queue", "bursts", memory.queue);
    }

    std::string text() const { return "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n" + events_ + "\n]}\n"; }

  private:
    std::int64_t ns(Cycles cycles) const { return std::llround(static_cast<double>(cycles) * ns_per_cycle_); }
    /// Perfetto cuts off what is left of a nanosecond: it must not be left of one too few.
    static double microseconds(std::int64_t ns) {
        double const time = static_cast<double>(ns) / 1e3;
        return static_cast<std::int64_t>(time * 1e3) < ns ? std::nextafter(time, HUGE_VAL) : time;
    }
    static std::string quoted(std::string const& text) { return io::text_of(Json(text)); }

    template <class... Arguments> void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        events_ += events_.empty() ? "" : ",\n";
        fmt::format_to(std::back_inserter(events_), format, std::forward<Arguments>(arguments)...);
    }
    void name(char const* what, std::size_t track, std::string const& text) {
        put(R"({{"name":"{}","ph":"M","pid":{},"tid":{},"args":{{"name":{}}}}})", what, process_, track, quoted(text));
    }
    void add_slice(std::size_t track, std::string const& text, char const* category, Cycles begin, Cycles end,
                   std::string const& args) {
        put(R"({{"name":{},"cat":"{}","ph":"X","pid":{},"tid":{},"ts":{},"dur":{},"args":{{{}}}}})", quoted(text),
            category, process_, track, microseconds(ns(begin)), microseconds(ns(end) - ns(begin)), args);
    }
    void add_counter(std::string const& text, char const* unit, std::vector<OccupancyPoint> const& points) {
        std::string const quoted_text = quoted(text);
        for (OccupancyPoint const& point : points)
            put(R"({{"name":{},"ph":"C","pid":{},"ts":{},"args":{{"{}":{}}}}})", quoted_text, process_,
                microseconds(ns(point.cycle)), unit, point.tokens);
    }
    template <class Span> static std::string cycles_of(Span const& span) {
        return fmt::format(R"("begin_cycle":{},"end_cycle":{})", span.begin, span.end - 1);
    }
    /// Samples overlap: the next is drawn while one is swept. Returns how many tracks they take.
    std::size_t add_samples(CoreTimeline const& core) {
        Lanes lanes;
        for (CoreTimeline::Sample const& sample : core.samples)
            add_slice(
                lanes.take(sample.begin, sample.end), fmt::format("sample {}", sample.sample), "sample", sample.begin,
                sample.end,
                fmt::format(R"({},"sample":{},"complete":{})", cycles_of(sample), sample.sample, sample.complete));
        for (std::size_t lane = 0; lane < lanes.count(); ++lane)
            name("thread_name", lane, lane == 0 ? "samples" : fmt::format("samples {}", lane + 1));
        return lanes.count();
    }
    void add_span(CoreTimeline const& timeline, std::size_t track, TimelineSpan const& span) {
        bool const is_loop = span.kind == TimelineSpan::Kind::loop;
        std::string const cycles =
            fmt::format(R"({},"{}":{})", cycles_of(span), is_loop ? "iterations" : "stalled_cycles", span.count);
        if (is_loop)
            return add_slice(track, timeline.machine->loops[span.item].name, "loop", span.begin, span.end, cycles);
        if (span.kind == TimelineSpan::Kind::memory_stall)
            return add_slice(track, "memory", "stall", span.begin, span.end, cycles);
        bool const is_full = span.kind == TimelineSpan::Kind::full_stall;
        std::string const& fifo = timeline.machine->fifos[span.item].name;
        add_slice(track, fifo + (is_full ? " full" : " empty"), "stall", span.begin, span.end,
                  fmt::format(R"("fifo":{},{})", quoted(fifo), cycles));
    }

    double ns_per_cycle_;
    std::size_t process_ = 0;
    std::size_t process_count_ = 0;
    std::string events_;
};

}  // namespace

MemoryTimeline make_memory_timeline(RecordedBursts const& memory, Cycles from, Cycles to, std::size_t most) {
    for (Cycles grain = 64;; grain *= 2) {
        MemoryTimeline timeline = Maker(memory, from, to, grain).make();
        if (size_of(timeline) <= most)
            return timeline;
    }
}

std::string timeline_json(std::vector<CoreTimeline> const& timelines, std::optional<MemoryTimeline> const& memory,
                          double clock_mhz) {
    TimelineWriter writer(clock_mhz);
    for (CoreTimeline const& timeline : timelines)
        writer.add(timeline);
    if (memory)
        writer.add(*memory);
    return writer.text();
}

}  // namespace dataflow::recording
