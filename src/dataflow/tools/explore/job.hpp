#pragma once
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>

#include "dataflow/base/host_clock.hpp"
#include "dataflow/base/json.hpp"

namespace dataflow::explore {

/// Work in the background, of which somebody asks now and then how far it is. It gives way to what people wait for, and
/// ends where nobody asks any more: the page was closed.
class Job {
  public:
    /// Thrown in a job that nobody wants any more.
    struct Cancelled : std::runtime_error {
        Cancelled() : std::runtime_error("cancelled") {}
    };
    /// To be told how many of how many steps are done, one thread at a time; and to be asked in between, by any,
    /// whether to go on. Both throw Cancelled if not.
    struct Progress {
        std::function<void(std::size_t done, std::size_t steps)> tell;
        std::function<void()> check;
    };
    /// Returns the result, or throws what says why there is none.
    using Work = std::function<Json(Progress const& progress)>;

    /// `patience`: how long it goes on without being asked for its state.
    explicit Job(Work work, HostClock::duration patience = std::chrono::seconds(20));
    /// Cancels it.
    ~Job();
    Job(Job const&) = delete;
    Job& operator=(Job const&) = delete;

    void cancel() { is_cancelled_ = true; }
    /// Tells the job that somebody waits, too. `state`: running, with `done` and `steps`; done, with `result`;
    /// cancelled; failed, with `error`.
    Json state();

  private:
    void run(Work const& work);
    void check() const;
    void end(Json state);

    HostClock::duration patience_;
    std::atomic<HostClock::time_point> asked_at_{HostClock::now()};
    std::atomic<bool> is_cancelled_{false};
    std::atomic<std::size_t> done_{0};
    std::atomic<std::size_t> steps_{0};
    mutable std::mutex mutex_;
    Json end_;  ///< null while it runs
    std::thread thread_;
};

}  // namespace dataflow::explore
