#pragma once
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "dataflow/core/time/core_timing.hpp"

namespace dataflow {

/// Gives the operations of all cores their cycles on a thread of its own, while the SystemC kernel goes on with what
/// modules do (decoupled). What they do does not depend on cycles, so figures are the same. From construction to
/// finish(), the cores' timing is the thread's alone.
class TimingThread {
  public:
    /// What the processes of a core have told, by process.
    using Told = std::vector<std::vector<timing::Operation>>;

    /// Throws std::system_error if there is no further thread.
    TimingThread();
    ~TimingThread();
    TimingThread(TimingThread const&) = delete;
    TimingThread& operator=(TimingThread const&) = delete;

    /// Waits if the thread is far behind.
    void tell(timing::CoreTiming& core, Told told);
    /// All that has been told has got its cycles, or waits. Throws what went wrong meanwhile.
    void finish();

  private:
    struct Work {
        timing::CoreTiming* core;
        Told told;
        std::size_t operations;
    };

    void work();
    void do_work(Work const& work);
    void stop();

    std::deque<Work> waiting_;
    std::size_t operations_waiting_ = 0;
    bool stops_ = false;
    std::exception_ptr error_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::thread thread_;
};

}  // namespace dataflow
