#include <algorithm>
#include <catch2/catch.hpp>

#include "dataflow/tools/sweeps/schedule.hpp"
#include "dataflow/tools/sweeps/shard.hpp"
#include "faster/dataflow_names.hpp"

namespace sweep_schedule_test {

using dataflow::sweeps::Assignment;
using dataflow::sweeps::Ending;
using dataflow::sweeps::PointIdentity;
using dataflow::sweeps::points_of_shard;
using dataflow::sweeps::Schedule;
using Kind = Assignment::Kind;
using Points = std::vector<std::size_t>;

/// The next assignment, which there has to be.
Assignment next(Schedule& schedule) {
    auto const assignment = schedule.next(1);
    REQUIRE(assignment);
    return *assignment;
}

Ending done(Assignment const& assignment, bool has_events = false) {
    return {assignment.points, has_events, false, false};
}

TEST_CASE("A function is recorded once, and its other points retimed", "[sweeps]") {
    Schedule schedule({{0, "f"}, {1, "f"}, {2, "f"}}, {});
    Assignment const first = next(schedule);
    CHECK(first.kind == Kind::record);
    CHECK(first.points == Points{0});
    CHECK_FALSE(schedule.next(1));  // nothing to do before it is recorded
    schedule.ended(first, done(first, true));
    Points retimed;
    while (auto const assignment = schedule.next(1)) {
        CHECK(assignment->kind == Kind::retime);
        CHECK_FALSE(schedule.is_finished("f"));
        retimed.insert(retimed.end(), assignment->points.begin(), assignment->points.end());
        schedule.ended(*assignment, done(*assignment));
    }
    CHECK(retimed == Points{1, 2});
    CHECK(schedule.is_finished("f"));
}

TEST_CASE("The only point of a function is simulated", "[sweeps]") {
    Schedule schedule({{0, "f"}, {1, "g"}}, {});
    CHECK(next(schedule).kind == Kind::simulate);
    CHECK(next(schedule).kind == Kind::simulate);
    CHECK_FALSE(schedule.next(1));
}

TEST_CASE("A function with an event file is not simulated", "[sweeps]") {
    Schedule schedule({{4, "f"}}, {"f"});
    CHECK(next(schedule).kind == Kind::retime);
}

TEST_CASE("If the recorded point has no event file, the last one is recorded", "[sweeps]") {
    Schedule schedule({{0, "f"}, {1, "f"}, {2, "f"}}, {});
    Assignment const first = next(schedule);
    schedule.ended(first, done(first, false));  // a deadlock
    Assignment const second = next(schedule);
    CHECK(second.kind == Kind::record);
    CHECK(second.points == Points{2});
    schedule.ended(second, done(second, false));
    CHECK(next(schedule).kind == Kind::simulate);
}

TEST_CASE("An event file that is no good is recorded anew", "[sweeps]") {
    Schedule schedule({{0, "f"}, {1, "f"}}, {"f"});
    Assignment const first = next(schedule);
    CHECK(first.kind == Kind::retime);
    schedule.ended(first, {{}, false, true, false});
    Assignment const second = next(schedule);
    CHECK(second.kind == Kind::record);
    CHECK(second.points == Points{0});
}

TEST_CASE("Points that a process had no time for come again", "[sweeps]") {
    std::vector<Schedule::Job> jobs;
    for (std::size_t i = 0; i < 20; ++i)
        jobs.push_back({i, "f"});
    Schedule schedule(jobs, {"f"});
    Assignment const batch = next(schedule);
    REQUIRE(batch.points.size() == 10);
    schedule.ended(batch, {{0, 1}, false, false, false});
    CHECK(next(schedule).points.front() == 2);
}

TEST_CASE("After a process got lost with several points, they come one by one", "[sweeps]") {
    std::vector<Schedule::Job> jobs;
    for (std::size_t i = 0; i < 20; ++i)
        jobs.push_back({i, "f"});
    Schedule schedule(jobs, {"f"});
    Assignment const batch = next(schedule);
    schedule.ended(batch, {{}, false, false, true});
    CHECK(next(schedule).points == Points{0});
    CHECK(next(schedule).points == Points{1});
}

TEST_CASE("Shards are disjoint, complete, of the same size, and keep functions together", "[sweeps]") {
    std::vector<PointIdentity> points;
    for (std::size_t i = 0; i < 40; ++i)
        points.push_back({std::to_string(i % 37), i % 2 == 0 ? "even" : "odd"});  // the last three are the first again
    for (std::size_t const count : std::vector<std::size_t>{1, 2, 3, 8, 37, 50}) {
        Points all;
        for (std::size_t index = 1; index <= count; ++index) {
            Points const part = points_of_shard(points, {index, count});
            CHECK(part.size() <= 37 / count + 1);
            CHECK(part.size() >= 37 / count);
            all.insert(all.end(), part.begin(), part.end());
        }
        std::sort(all.begin(), all.end());
        REQUIRE(all.size() == 37);
        for (std::size_t i = 0; i < all.size(); ++i)
            CHECK(all[i] == i);
    }
    for (std::size_t const point : points_of_shard(points, {1, 2}))
        CHECK((point % 2 == 0));
}

}  // namespace sweep_schedule_test
