#include "dataflow/tools/explore/job.hpp"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace dataflow::explore {

namespace {

/// Of this thread and those that it will start; Linux has a priority per thread.
void give_way() {
    constexpr int nice = 10;
    setpriority(PRIO_PROCESS, static_cast<id_t>(syscall(SYS_gettid)), nice);
}

}  // namespace

Job::Job(Work work, HostClock::duration patience)
    : patience_(patience), thread_([this, work = std::move(work)] { run(work); }) {}

Job::~Job() {
    cancel();
    thread_.join();
}

void Job::run(Work const& work) {
    give_way();
    Progress const progress{[this](std::size_t done, std::size_t steps) {
                                done_ = done;
                                steps_ = steps;
                                check();
                            },
                            [this] { check(); }};
    try {
        Json result = work(progress);
        end({{"state", "done"}, {"result", std::move(result)}});
    } catch (Cancelled const&) {
        end({{"state", "cancelled"}});
    } catch (std::exception const& error) {
        end({{"state", "failed"}, {"error", error.what()}});
    }
}

void Job::check() const {
    if (is_cancelled_ || HostClock::now() - asked_at_.load() > patience_)
        throw Cancelled();
}

void Job::end(Json state) {
    std::lock_guard<std::mutex> const lock(mutex_);
    end_ = std::move(state);
}

Json Job::state() {
    asked_at_ = HostClock::now();
    std::lock_guard<std::mutex> const lock(mutex_);
    return end_.is_null() ? Json{{"state", "running"}, {"done", done_.load()}, {"steps", steps_.load()}} : end_;
}

}  // namespace dataflow::explore
