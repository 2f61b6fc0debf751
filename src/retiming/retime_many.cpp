#include "retiming/retime_many.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace faster::retiming {

namespace {

using Done = std::function<void(std::size_t, RunStatistics const&)>;

/// Lets threads take one configuration after the other.
template <class Run> class Pool {
  public:
    Pool(Run const& run, std::vector<AcceleratorConfig> const& configs, Done const& done)
        : run_(run), configs_(configs), done_(done) {}

    void work() {
        std::size_t const useful = std::min<std::size_t>(std::thread::hardware_concurrency(), configs_.size());
        std::vector<std::thread> others;
        for (std::size_t i = 1; i < useful; ++i)
            others.emplace_back([this] { take_configs(); });
        take_configs();
        for (std::thread& other : others)
            other.join();
        if (error_)
            std::rethrow_exception(error_);
    }

  private:
    void take_configs() {
        try {
            for (std::size_t i = next_++; i < configs_.size(); i = next_++) {
                RunStatistics const retimed = retime(run_, configs_[i]);
                std::lock_guard<std::mutex> const lock(mutex_);
                done_(i, retimed);
            }
        } catch (...) {
            next_ = configs_.size();
            std::lock_guard<std::mutex> const lock(mutex_);
            error_ = std::current_exception();
        }
    }

    Run const& run_;
    std::vector<AcceleratorConfig> const& configs_;
    Done const& done_;
    std::atomic<std::size_t> next_{0};
    std::exception_ptr error_;
    std::mutex mutex_;
};

}  // namespace

void retime_many(RecordedRun const& run, std::vector<AcceleratorConfig> const& configs, Done const& done) {
    constexpr std::size_t worth_scripting = 3;  // to make a run ready takes as long as to retime it once
    if (configs.size() >= worth_scripting)
        retime_many(ScriptedRun(run, configs.front().flow), configs, done);
    else
        Pool(run, configs, done).work();
}

void retime_many(ScriptedRun const& run, std::vector<AcceleratorConfig> const& configs, Done const& done) {
    Pool(run, configs, done).work();
}

}  // namespace faster::retiming
