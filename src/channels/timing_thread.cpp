#include "channels/timing_thread.hpp"

#include <utility>

namespace dataflow {

namespace {
constexpr std::size_t most_waiting = std::size_t{1} << 20;  // operations, of 8 bytes
}  // namespace

TimingThread::TimingThread() : thread_([this] { work(); }) {}

TimingThread::~TimingThread() { stop(); }

void TimingThread::tell(timing::CoreTiming& core, Told told) {
    std::size_t operations = 0;
    for (std::vector<timing::Operation> const& process : told)
        operations += process.size();
    if (operations == 0)
        return;
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return operations_waiting_ < most_waiting; });
    waiting_.push_back({&core, std::move(told), operations});
    operations_waiting_ += operations;
    changed_.notify_all();
}

void TimingThread::finish() {
    stop();
    if (error_)
        std::rethrow_exception(error_);
}

void TimingThread::stop() {
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        stops_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable())
        thread_.join();
}

void TimingThread::work() {
    for (;;) {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return stops_ || !waiting_.empty(); });
        if (waiting_.empty())
            return;
        Work const work = std::move(waiting_.front());
        waiting_.pop_front();
        operations_waiting_ -= work.operations;
        changed_.notify_all();
        lock.unlock();
        if (!error_)
            do_work(work);
    }
}

void TimingThread::do_work(Work const& work) {
    try {
        for (std::size_t i = 0; i < work.told.size(); ++i)
            for (timing::Operation const& operation : work.told[i])
                work.core->process(i).log().append(operation);
        work.core->resolve(false);
    } catch (...) {
        error_ = std::current_exception();
    }
}

}  // namespace dataflow
