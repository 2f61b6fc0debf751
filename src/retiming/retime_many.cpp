#include "retiming/retime_many.hpp"

#include <mutex>

#include "common/on_threads.hpp"

namespace faster::retiming {

namespace {

using Done = std::function<void(std::size_t, RunStatistics const&)>;

template <class Run> void retime_all(Run const& run, std::vector<AcceleratorConfig> const& configs, Done const& done) {
    std::mutex mutex;
    on_threads(configs.size(), jobs_or_host_cores(0), [&](std::size_t i) {
        RunStatistics const retimed = retime(run, configs[i]);
        std::lock_guard<std::mutex> const lock(mutex);
        done(i, retimed);
    });
}

}  // namespace

void retime_many(RecordedRun const& run, std::vector<AcceleratorConfig> const& configs, Done const& done) {
    constexpr std::size_t worth_scripting = 3;  // to make a run ready takes as long as to retime it once
    if (configs.size() >= worth_scripting)
        retime_many(ScriptedRun(run, Parts(configs.front())), configs, done);
    else
        retime_all(run, configs, done);
}

void retime_many(ScriptedRun const& run, std::vector<AcceleratorConfig> const& configs, Done const& done) {
    retime_all(run, configs, done);
}

}  // namespace faster::retiming
