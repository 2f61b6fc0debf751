#include "retiming/sensitivities.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

#include "config/config_sources.hpp"
#include "config/keys.hpp"
#include "retiming/retime.hpp"

namespace faster::retiming {

namespace {

/// One retiming to do, and where its result goes.
struct Task {
    AcceleratorConfig config;
    SensitivityStep* step;
};

void add_step(LoadedConfig const& loaded, Key const& key, std::int64_t value, SensitivityStep& step,
              std::vector<Task>& tasks) {
    LoadedConfig changed = loaded;
    key.write(changed.config, KeyValue{value});
    step.valid = accepts(key.integers, value) && cross_check(changed).empty();
    if (step.valid)
        tasks.push_back({changed.config.accelerator, &step});
}

/// Lets threads take one task after the other.
class Pool {
  public:
    Pool(RecordedRun const& run, std::vector<Task> const& tasks,
         std::function<void(std::size_t, std::size_t)> const& progress)
        : run_(run), tasks_(tasks), progress_(progress) {}

    void work() {
        std::vector<std::thread> others;
        for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
            others.emplace_back([this] { take_tasks(); });
        take_tasks();
        for (std::thread& other : others)
            other.join();
        if (error_)
            std::rethrow_exception(error_);
    }

  private:
    void take_tasks() {
        try {
            for (std::size_t i = next_++; i < tasks_.size(); i = next_++)
                perform(tasks_[i]);
        } catch (...) {
            next_ = tasks_.size();
            std::lock_guard<std::mutex> const lock(mutex_);
            error_ = std::current_exception();
        }
    }

    void perform(Task const& task) {
        RunStatistics const retimed = retime(run_, task.config);
        task.step->deadlocks = retimed.deadlocked();
        task.step->total_cycles = retimed.deadlocked() ? 0 : retimed.total_cycles;
        std::lock_guard<std::mutex> const lock(mutex_);
        ++done_;
        if (progress_)
            progress_(done_, tasks_.size());
    }

    RecordedRun const& run_;
    std::vector<Task> const& tasks_;
    std::function<void(std::size_t, std::size_t)> const& progress_;
    std::atomic<std::size_t> next_{0};
    std::size_t done_ = 0;
    std::exception_ptr error_;
    std::mutex mutex_;
};

}  // namespace

std::vector<Sensitivity> sensitivities(RecordedRun const& run, LoadedConfig const& loaded,
                                       std::function<void(std::size_t, std::size_t)> const& progress) {
    Keys const keys = timing_keys();
    std::vector<Sensitivity> rows(keys.size());
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        rows[i].key = keys[i].name();
        rows[i].value = std::get<std::int64_t>(keys[i].read(loaded.config));
        add_step(loaded, keys[i], rows[i].value - 1, rows[i].down, tasks);
        add_step(loaded, keys[i], rows[i].value + 1, rows[i].up, tasks);
    }
    Pool(run, tasks, progress).work();
    return rows;
}

}  // namespace faster::retiming
