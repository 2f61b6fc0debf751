#include "kernel/replay/retime_many.hpp"

#include <mutex>

#include "kernel/base/on_threads.hpp"

namespace faster::retiming {

void retime_many(RecordedRun const& run, std::vector<AcceleratorConfig> const& configs, Done const& done) {
    if (!configs.empty())
        retime_many(ScriptedRun(run, Parts(configs.front())), configs, done);
}

void retime_many(ScriptedRun const& run, std::vector<AcceleratorConfig> const& configs, Done const& done) {
    std::mutex mutex;
    on_threads(configs.size(), jobs_or_host_cores(0), [&](std::size_t i) {
        RunStatistics const retimed = retime(run, configs[i]);
        std::lock_guard<std::mutex> const lock(mutex);
        done(i, retimed);
    });
}

}  // namespace faster::retiming
