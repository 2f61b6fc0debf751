#include "dataflow/run/replay/retime_many.hpp"

#include <mutex>

#include "dataflow/base/on_threads.hpp"

namespace dataflow::replay {

void retime_many(RecordedRun const& run, std::vector<Machine> const& machines, Done const& done) {
    if (!machines.empty())
        retime_many(ScriptedRun(run, run.lead(machines.front())), machines, done);
}

void retime_many(ScriptedRun const& run, std::vector<Machine> const& machines, Done const& done) {
    std::mutex mutex;
    on_threads(machines.size(), jobs_or_host_cores(0), [&](std::size_t i) {
        RunStatistics const retimed = retime(run, machines[i]);
        std::lock_guard<std::mutex> const lock(mutex);
        done(i, retimed);
    });
}

}  // namespace dataflow::replay
