#include "kernel/report/html/timeline_data.hpp"

#include <cmath>

#include "kernel/figures/cycle_class.hpp"
#include "kernel/report/html/timeline_view.hpp"

namespace faster::report {

namespace {

char const* kind_name(TimelineSpan::Kind kind) {
    switch (kind) {
        case TimelineSpan::Kind::loop:
            return "loop";
        case TimelineSpan::Kind::empty_stall:
            return name_of(CycleClass::empty_stall);
        case TimelineSpan::Kind::full_stall:
            return name_of(CycleClass::full_stall);
        case TimelineSpan::Kind::memory_stall:
            return name_of(CycleClass::memory_stall);
    }
    return "";
}

std::string item_name(Machine const& machine, TimelineSpan const& span) {
    if (span.kind == TimelineSpan::Kind::memory_stall)
        return "memory";
    return span.kind == TimelineSpan::Kind::loop ? machine.loops[span.item].name : machine.fifos[span.item].name;
}

/// Short rows, because there are thousands: module, kind, item, begin, end, cycles, iterations of a loop, spans.
Json spans(Machine const& machine, SampleTimeline const& timeline) {
    constexpr Cycles distinguishable = 2000;  // positions along a wide screen
    Json rows = Json::array();
    for (MergedSpan const& span : merged_spans(timeline.spans, (timeline.end - timeline.begin) / distinguishable))
        rows.push_back({machine.processes[span.extent.module].name, kind_name(span.extent.kind),
                        item_name(machine, span.extent), span.extent.begin, span.extent.end, span.cycles,
                        span.extent.kind == TimelineSpan::Kind::loop ? span.extent.count : 0, span.spans});
    return rows;
}

Json occupancy(Machine const& machine, SampleTimeline const& timeline) {
    constexpr std::size_t parts = 120;
    Json fifo_profiles = Json::object();
    for (std::size_t f = 0; f < timeline.occupancy.size(); ++f) {
        Json means = Json::array(), maxima = Json::array();
        for (OccupancyPart const& part :
             occupancy_profile(timeline.occupancy[f], timeline.begin, timeline.end, parts)) {
            means.push_back(std::round(part.mean * 1000) / 1000);
            maxima.push_back(part.max);
        }
        if (!means.empty())
            fifo_profiles[machine.fifos[f].name] = {{"mean", means}, {"max", maxima}};
    }
    return fifo_profiles;
}

}  // namespace

Json timeline_data(Machine const& machine, SampleTimeline const& timeline) {
    return {{"core", timeline.core}, {"sample", timeline.sample},         {"begin", timeline.begin},
            {"end", timeline.end},   {"spans", spans(machine, timeline)}, {"occupancy", occupancy(machine, timeline)}};
}

}  // namespace faster::report
