#pragma once
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace dataflow {

/// A thread that does what it is told, one after the other.
class Worker {
  public:
    /// Work waits for it up to this size in all, of whatever unit. Throws std::system_error if there is no further
    /// thread.
    explicit Worker(std::size_t most_waiting);
    /// What was told is done.
    ~Worker();
    Worker(Worker const&) = delete;
    Worker& operator=(Worker const&) = delete;

    /// Waits if the thread is far behind. Behind work that throws, it does no more.
    void tell(std::size_t size, std::function<void()> work);
    /// All is done. Throws what went wrong meanwhile.
    void finish();

  private:
    struct Waiting {
        std::size_t size;
        std::function<void()> work;
    };

    void run();
    void do_work(Waiting const& next);
    void stop();

    std::size_t most_waiting_;
    std::deque<Waiting> waiting_;
    std::size_t size_waiting_ = 0;
    bool stops_ = false;
    std::exception_ptr error_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::thread thread_;
};

}  // namespace dataflow
