#include "dataflow/tools/recording/thinned_timeline.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace dataflow::recording {

namespace {

using Spans = std::vector<TimelineSpan>;

/// Spans shorter than the grain divided by this are left out.
constexpr Cycles shortest_shown = 4;

std::size_t points_of(CoreTimeline const& timeline) {
    std::size_t points = 0;
    for (auto const& of_fifo : timeline.occupancy)
        points += of_fifo.size();
    return points;
}

/// Joins neighbours on the same level of one module. Stalls stay in their loop.
class Joiner {
  public:
    Joiner(Spans& joined, Cycles grain) : joined_(joined), grain_(grain) {}

    void take(TimelineSpan const& span) {
        bool const is_loop = span.kind == TimelineSpan::Kind::loop;
        std::size_t& last = is_loop ? loop_ : stall_;
        if (last != none && joins(joined_[last], span)) {
            joined_[last].end = std::max(joined_[last].end, span.end);
            joined_[last].count += span.count;
            return;
        }
        if (is_loop)
            stall_ = none;
        last = joined_.size();
        joined_.push_back(span);
    }

  private:
    static constexpr std::size_t none = ~std::size_t{0};

    bool joins(TimelineSpan const& last, TimelineSpan const& next) const {
        bool const is_same = last.kind == next.kind && last.item == next.item && next.begin <= last.end + grain_;
        bool const leaves_loop = next.kind != TimelineSpan::Kind::loop && loop_ != none &&
                                 last.begin < joined_[loop_].end && next.end > joined_[loop_].end;
        return is_same && !leaves_loop;
    }

    Spans& joined_;
    Cycles grain_;
    std::size_t loop_ = none;   // the last one
    std::size_t stall_ = none;  // the last one, behind the begin of that loop
};

Spans join(Spans const& spans, Cycles grain) {
    std::map<std::size_t, Spans> of_modules;
    for (TimelineSpan const& span : spans)
        of_modules[span.module].push_back(span);
    Spans all;
    for (auto const& [module, own] : of_modules) {
        Spans joined;
        Joiner joiner(joined, grain);
        for (TimelineSpan const& span : own)
            joiner.take(span);
        std::copy_if(joined.begin(), joined.end(), std::back_inserter(all),
                     [grain](TimelineSpan const& span) { return (span.end - span.begin) * shortest_shown >= grain; });
    }
    std::stable_sort(all.begin(), all.end(), outermost_first);
    return all;
}

/// The largest value in each stretch of `grain` cycles, from the first point on.
std::vector<OccupancyPoint> largest_in_stretches(std::vector<OccupancyPoint> const& points, Cycles grain) {
    std::vector<OccupancyPoint> thinned;
    auto const put = [&thinned](Cycles cycle, std::uint64_t tokens) {
        if (!thinned.empty() && thinned.back().cycle == cycle)
            thinned.back().tokens = std::max(thinned.back().tokens, tokens);
        else if (thinned.empty() || thinned.back().tokens != tokens)
            thinned.push_back({cycle, tokens});
    };
    for (std::size_t i = 0; i < points.size(); ++i) {
        Cycles const stretch = points[i].cycle - (points[i].cycle - points.front().cycle) % grain;
        put(stretch, points[i].tokens);
        bool const is_last = i + 1 == points.size();
        if (is_last || points[i + 1].cycle > stretch + grain)
            put(stretch + grain, points[i].tokens);  // what it is from then on
    }
    return thinned;
}

}  // namespace

CoreTimeline thinned(CoreTimeline timeline, std::size_t most) {
    for (Cycles grain = 128; timeline.spans.size() > most / 2; grain *= 2)
        timeline.spans = join(timeline.spans, grain);
    for (Cycles grain = 128; points_of(timeline) > most / 2; grain *= 2)
        for (auto& points : timeline.occupancy)
            points = largest_in_stretches(points, grain);
    return timeline;
}

}  // namespace dataflow::recording
