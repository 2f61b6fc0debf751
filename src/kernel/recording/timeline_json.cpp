#include "kernel/recording/timeline_json.hpp"

#include "kernel/base/files/json_file.hpp"
#include "kernel/base/json.hpp"

namespace faster::recording {

namespace {

constexpr std::size_t samples_track = 0;
constexpr std::size_t track_of(std::size_t module) { return 1 + module; }

class Writer {
  public:
    explicit Writer(double clock_mhz) : clock_mhz_(clock_mhz) {}

    void add(CoreTimeline const& core) {
        name_tracks(core);
        for (CoreTimeline::Sample const& sample : core.samples)
            add_slice(core.core, samples_track, "sample " + std::to_string(sample.sample), "sample", sample.begin,
                      sample.end, {{"sample", sample.sample}, {"complete", sample.complete}});
        for (TimelineSpan const& span : core.spans)
            add_span(core, span);
        for (std::size_t fifo = 0; fifo < core.occupancy.size(); ++fifo)
            for (OccupancyPoint const& point : core.occupancy[fifo])
                add_event({{"name", core.machine->fifos[fifo].name},
                           {"ph", "C"},
                           {"pid", core.core},
                           {"ts", microseconds(point.cycle)},
                           {"args", {{"tokens", point.tokens}}}});
    }
    std::string text() const { return "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[\n" + events_ + "\n]}\n"; }

  private:
    double microseconds(Cycles cycles) const { return static_cast<double>(cycles) / clock_mhz_; }
    void add_event(Json const& event) {
        events_ += events_.empty() ? "" : ",\n";
        events_ += io::text_of(event);
    }
    void name_tracks(CoreTimeline const& timeline) {
        std::size_t const core = timeline.core;
        name("process_name", core, 0, "core " + std::to_string(core));
        name("thread_name", core, samples_track, "samples");
        for (std::size_t const module : modules_of(*timeline.machine))
            name("thread_name", core, track_of(module), timeline.machine->processes[module].name);
    }
    void name(char const* what, std::size_t core, std::size_t track, std::string const& text) {
        add_event({{"name", what}, {"ph", "M"}, {"pid", core}, {"tid", track}, {"args", {{"name", text}}}});
    }
    void add_slice(std::size_t core, std::size_t track, std::string const& text, char const* category, Cycles begin,
                   Cycles end, Json const& args) {
        add_event({{"name", text},
                   {"cat", category},
                   {"ph", "X"},
                   {"pid", core},
                   {"tid", track},
                   {"ts", microseconds(begin)},
                   {"dur", microseconds(end - begin)},
                   {"args", args}});
    }
    void add_span(CoreTimeline const& timeline, TimelineSpan const& span) {
        std::size_t const core = timeline.core;
        std::size_t const track = track_of(span.module);
        if (span.kind == TimelineSpan::Kind::loop) {
            add_slice(core, track, timeline.machine->loops[span.item].name, "loop", span.begin, span.end,
                      {{"begin_cycle", span.begin}, {"end_cycle", span.end}, {"iterations", span.count}});
            return;
        }
        if (span.kind == TimelineSpan::Kind::memory_stall) {
            add_slice(core, track, "memory", "stall", span.begin, span.end,
                      {{"begin_cycle", span.begin}, {"end_cycle", span.end}, {"stalled_cycles", span.count}});
            return;
        }
        bool const is_full = span.kind == TimelineSpan::Kind::full_stall;
        std::string const& fifo = timeline.machine->fifos[span.item].name;
        add_slice(
            core, track, fifo + (is_full ? " full" : " empty"), "stall", span.begin, span.end,
            {{"fifo", fifo}, {"begin_cycle", span.begin}, {"end_cycle", span.end}, {"stalled_cycles", span.count}});
    }

    double clock_mhz_;
    std::string events_;
};

}  // namespace

std::string timeline_json(std::vector<CoreTimeline> const& timelines, double clock_mhz) {
    Writer writer(clock_mhz);
    for (CoreTimeline const& timeline : timelines)
        writer.add(timeline);
    return writer.text();
}

}  // namespace faster::recording
