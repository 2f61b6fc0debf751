#include <catch2/catch.hpp>
#include <chrono>
#include <thread>

#include "dataflow/tools/explore/job.hpp"

namespace dataflow::explore::job_test {

using std::chrono::milliseconds;

/// Goes on until it is told not to.
Json go_on(Job::Progress const& progress) {
    for (;; std::this_thread::sleep_for(milliseconds(1)))
        progress.check();
}

/// Without asking in between.
std::string state_after(Job& job, milliseconds wait) {
    std::this_thread::sleep_for(wait);
    return job.state()["state"];
}

TEST_CASE("A search ends where nobody asks how far it is", "[explore]") {
    Job forgotten(go_on, milliseconds(20));
    CHECK(state_after(forgotten, milliseconds(500)) == "cancelled");
}

TEST_CASE("A search goes on while somebody asks", "[explore]") {
    Job wanted(go_on, milliseconds(2000));
    for (int i = 0; i < 25; ++i)
        CHECK(state_after(wanted, milliseconds(100)) == "running");
}

}  // namespace dataflow::explore::job_test
