#include "kernel/report/html/timeline_view.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace faster::report {

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

}  // namespace faster::report
