#include <catch2/catch.hpp>
#include <numeric>

#include "dataflow/tools/report/html/timeline_data.hpp"
#include "dataflow/tools/report/latencies.hpp"
#include "faster/dataflow_names.hpp"
#include "support/example_run.hpp"

namespace dataflow::report::report_figures_test {

using Counts = std::vector<std::uint64_t>;

TEST_CASE("A histogram has bins of 1, 2 or 5 times a power of ten, 30 at most", "[html]") {
    LatencyHistogram const narrow = latency_histogram({7, 7, 8, 36});
    CHECK(narrow.first == 7);
    CHECK(narrow.width == 1);
    REQUIRE(narrow.counts.size() == 30);
    CHECK(narrow.counts[0] == 2);
    CHECK(narrow.counts[1] == 1);
    CHECK(narrow.counts[29] == 1);

    for (Cycles last = 36; last < 3000000; last = last * 3 / 2) {
        LatencyHistogram const histogram = latency_histogram({7, last / 2, last});
        CAPTURE(last, histogram.width);
        Cycles leading = histogram.width;
        while (leading % 10 == 0)
            leading /= 10;
        CHECK((leading == 1 || leading == 2 || leading == 5));
        CHECK(histogram.first % histogram.width == 0);
        CHECK(histogram.counts.size() <= 30);
        CHECK(histogram.counts.size() >= 12);  // no coarser than needed
        CHECK(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}) == 3);
    }
}

TEST_CASE("Equal latencies are one bin, no latencies none", "[html]") {
    CHECK(latency_histogram({1000, 1000}).counts == Counts{2});
    CHECK(latency_histogram({}).counts.empty());
}

constexpr auto loop = TimelineSpan::Kind::loop;
constexpr auto stall = TimelineSpan::Kind::full_stall;

TEST_CASE("Spans closer than the resolution become one, with the cycles and number of both", "[html]") {
    std::vector<MergedSpan> const merged =
        merged_spans({{2, loop, 1, 0, 10}, {2, loop, 1, 19, 30}, {2, loop, 1, 40, 50}}, 10);
    REQUIRE(merged.size() == 2);  // 9 cycles between the first two, 10 before the third
    CHECK(merged[0].extent.begin == 0);
    CHECK(merged[0].extent.end == 30);
    CHECK(merged[0].cycles == 21);
    CHECK(merged[0].spans == 2);
    CHECK(merged[1].extent.begin == 40);
    CHECK(merged[1].cycles == 10);
}

TEST_CASE("The cycles of merged stalls are those stalled, of merged loops those inside", "[html]") {
    std::vector<MergedSpan> const merged = merged_spans(
        {{2, loop, 1, 0, 10, 7}, {2, stall, 1, 0, 10, 4}, {2, loop, 1, 12, 20, 5}, {2, stall, 1, 12, 20, 2}}, 10);
    REQUIRE(merged.size() == 2);
    CHECK(merged[0].cycles == 18);
    CHECK(merged[0].extent.count == 12);  // iterations
    CHECK(merged[1].cycles == 6);
}

TEST_CASE("Only spans of the same module, kind and item are merged", "[html]") {
    std::vector<TimelineSpan> const spans{
        {2, loop, 1, 0, 10}, {3, loop, 1, 5, 15}, {2, stall, 1, 5, 9}, {2, loop, 2, 10, 20}};
    CHECK(merged_spans(spans, 1000).size() == 4);
}

TEST_CASE("Spans that touch stay apart when every cycle can be seen", "[html]") {
    CHECK(merged_spans({{2, loop, 1, 0, 10}, {2, loop, 1, 10, 20}}, 0).size() == 2);
}

TEST_CASE("A long sample has no more bars than a wide screen has places", "[html]") {
    SampleTimeline const timeline = faster::test::example_timeline(0, 0, 0);
    Cycles const resolution = (timeline.end - timeline.begin) / 100;
    std::vector<MergedSpan> const merged = merged_spans(timeline.spans, resolution);
    CHECK(merged.size() < timeline.spans.size() / 10);
    std::uint64_t spans = 0;
    for (MergedSpan const& span : merged)
        spans += span.spans;
    CHECK(spans == timeline.spans.size());
}

TEST_CASE("An occupancy profile weighs the tokens by their time", "[html]") {
    std::vector<OccupancyPart> const profile = occupancy_profile({{90, 2}, {105, 0}, {110, 4}, {112, 1}}, 100, 120, 2);
    REQUIRE(profile.size() == 2);
    CHECK(profile[0].mean == Approx(2 * 5 / 10.0));
    CHECK(profile[0].max == 2);
    CHECK(profile[1].mean == Approx((4 * 2 + 1 * 8) / 10.0));
    CHECK(profile[1].max == 4);
}

TEST_CASE("An occupancy profile has no part shorter than a cycle, and is empty without points", "[html]") {
    CHECK(occupancy_profile({{0, 1}}, 0, 3, 100).size() == 3);
    CHECK(occupancy_profile({}, 0, 3, 100).empty());
    CHECK(occupancy_profile({{0, 1}}, 3, 3, 100).empty());
}

TEST_CASE("The cycles of an example add up like those of a run", "[html]") {
    RunStatistics const run = faster::test::example_run();
    for (CoreStatistics const& core : run.cores)
        for (std::size_t const i : modules_of(run.machine))
            CHECK(core.processes[i].sum() == run.total_cycles);
}

}  // namespace dataflow::report::report_figures_test
