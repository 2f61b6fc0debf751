#include "dataflow/run/replay/retime_many.hpp"

#include <mutex>

#include "dataflow/base/on_threads.hpp"
#include "dataflow/run/replay/core_variant.hpp"

namespace dataflow::replay {

namespace {
std::optional<RunStatistics> retimed_if_known(ScriptedRun const& run, Machine const& machine) {
    try {
        return retime(run, machine);
    } catch (NotRetimable const&) {
        return std::nullopt;
    }
}
}  // namespace

void require_run_on(Machine const& machine, RecordedRun const& run) { core_variant(*run.blueprint, machine); }

bool allows_run_on(Machine const& machine, RecordedRun const& run) {
    try {
        require_run_on(machine, run);
        return true;
    } catch (NotRetimable const&) {
        return false;
    }
}

void retime_many(RecordedRun const& run, std::vector<Machine> const& machines, Done const& done) {
    if (!machines.empty())
        retime_many(ScriptedRun(run, machines.size() > 2 ? ScriptedRun::Uses::many : ScriptedRun::Uses::few), machines,
                    done);
}

void retime_many(ScriptedRun const& run, std::vector<Machine> const& machines, Done const& done) {
    std::mutex mutex;
    on_threads(machines.size(), jobs_or_host_cores(0), [&](std::size_t i) {
        std::optional<RunStatistics> const retimed = retimed_if_known(run, machines[i]);
        std::lock_guard<std::mutex> const lock(mutex);
        done(i, retimed);
    });
}

}  // namespace dataflow::replay
