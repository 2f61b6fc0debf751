#include "dataflow/tools/report/html/timeline_data.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "dataflow/run/figures/cycle_class.hpp"

namespace dataflow::report {

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

std::vector<MergedSpan> merged_spans(std::vector<TimelineSpan> const& spans, Cycles resolution) {
    std::vector<MergedSpan> merged;
    std::map<std::tuple<std::size_t, TimelineSpan::Kind, std::size_t>, std::size_t> latest;  // index into merged
    for (TimelineSpan const& span : spans) {
        auto const [at, is_first] = latest.try_emplace({span.module, span.kind, span.item}, merged.size());
        if (is_first || span.begin >= merged[at->second].extent.end + resolution) {
            at->second = merged.size();
            merged.push_back({span, 0, 0});
            merged.back().extent.count = 0;
        }
        MergedSpan& target = merged[at->second];
        target.extent.end = std::max(target.extent.end, span.end);
        target.extent.count += span.count;
        target.cycles += span.kind == TimelineSpan::Kind::loop ? span.end - span.begin : span.count;
        ++target.spans;
    }
    return merged;
}

std::vector<OccupancyPart> occupancy_profile(std::vector<OccupancyPoint> const& points, Cycles begin, Cycles end,
                                             std::size_t parts) {
    if (points.empty() || begin >= end)
        return {};
    Cycles const length = end - begin;
    auto const count = std::min<Cycles>(parts, length);
    std::vector<OccupancyPart> profile(count);
    std::size_t next = 0;  // the first point after `cycle`
    std::uint64_t tokens = 0;
    for (Cycles part = 0; part < count; ++part) {
        Cycles cycle = begin + length * part / count;
        Cycles const part_end = begin + length * (part + 1) / count;
        Cycles const part_length = part_end - cycle;
        Cycles token_cycles = 0;
        while (cycle < part_end) {
            while (next < points.size() && points[next].cycle <= cycle)
                tokens = points[next++].tokens;
            Cycles const until = next < points.size() ? std::min(points[next].cycle, part_end) : part_end;
            token_cycles += tokens * (until - cycle);
            profile[part].max = std::max(profile[part].max, tokens);
            cycle = until;
        }
        profile[part].mean = static_cast<double>(token_cycles) / static_cast<double>(part_length);
    }
    return profile;
}

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

}  // namespace dataflow::report
