#include "kernel/report/html/timeline_data.hpp"

#include <cmath>

#include "kernel/figures/cycle_class.hpp"

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

}  // namespace

Cycles coarse_resolution(SampleTimeline const& timeline) {
    constexpr Cycles distinguishable = 2000;  // positions along a wide screen
    return (timeline.end - timeline.begin) / distinguishable;
}

Json span_item(Machine const& machine, TimelineSpan const& span) {
    return {machine.processes[span.module].name, kind_name(span.kind), item_name(machine, span)};
}

std::uint64_t iterations_of(MergedSpan const& span) {
    return span.extent.kind == TimelineSpan::Kind::loop ? span.extent.count : 0;
}

namespace {

/// Short rows, because there are thousands: module, kind, item, begin, end, cycles, iterations of a loop, spans.
Json span_rows(Machine const& machine, std::vector<MergedSpan> const& spans) {
    Json rows = Json::array();
    for (MergedSpan const& span : spans) {
        rows.push_back(span_item(machine, span.extent));
        for (std::uint64_t const number :
             {span.extent.begin, span.extent.end, span.cycles, iterations_of(span), span.spans})
            rows.back().push_back(number);
    }
    return rows;
}

}  // namespace

Json occupancy_data(Machine const& machine, SampleTimeline const& timeline) {
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

Json timeline_data(Machine const& machine, SampleTimeline const& timeline) {
    return {{"core", timeline.core},
            {"sample", timeline.sample},
            {"begin", timeline.begin},
            {"end", timeline.end},
            {"spans", span_rows(machine, merged_spans(timeline.spans, coarse_resolution(timeline)))},
            {"occupancy", occupancy_data(machine, timeline)}};
}

}  // namespace faster::report
