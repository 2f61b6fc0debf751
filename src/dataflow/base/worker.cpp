#include "dataflow/base/worker.hpp"

#include <utility>

namespace dataflow {

Worker::Worker(std::size_t most_waiting) : most_waiting_(most_waiting), thread_([this] { run(); }) {}

Worker::~Worker() { stop(); }

void Worker::tell(std::size_t size, std::function<void()> work) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [this] { return size_waiting_ < most_waiting_; });
    waiting_.push_back({size, std::move(work)});
    size_waiting_ += size;
    changed_.notify_all();
}

void Worker::finish() {
    stop();
    if (error_)
        std::rethrow_exception(error_);
}

void Worker::stop() {
    {
        std::lock_guard<std::mutex> const lock(mutex_);
        stops_ = true;
        changed_.notify_all();
    }
    if (thread_.joinable())
        thread_.join();
}

void Worker::run() {
    for (;;) {
        std::unique_lock<std::mutex> lock(mutex_);
        changed_.wait(lock, [this] { return stops_ || !waiting_.empty(); });
        if (waiting_.empty())
            return;
        Waiting const next = std::move(waiting_.front());
        waiting_.pop_front();
        size_waiting_ -= next.size;
        changed_.notify_all();
        lock.unlock();
        if (!error_)
            do_work(next);
    }
}

void Worker::do_work(Waiting const& next) {
    try {
        next.work();
    } catch (...) {
        error_ = std::current_exception();
    }
}

}  // namespace dataflow
