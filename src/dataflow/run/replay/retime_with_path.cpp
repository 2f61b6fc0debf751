#include "dataflow/run/replay/retime_with_path.hpp"

#include "dataflow/run/replay/critical_path_of.hpp"
#include "dataflow/run/replay/retime.hpp"
#include "dataflow/run/replay/retime_together.hpp"

namespace dataflow::replay {

RunStatistics retime_with_path(ScriptedRun const& scripted, Machine const& machine) {
    if (scripted.run().memory)
        return retime_together(scripted, machine, true);
    RunStatistics run = retime(scripted, machine);
    if (run.deadlocked())
        return run;
    CoreOptions options;
    options.leave_trails = true;
    Cores const cores = retime_cores(scripted, machine, {run.last_core()}, options);
    run.critical_path = CriticalPath{run.last_core(), critical_path_of(*cores.front(), machine)};
    return run;
}

}  // namespace dataflow::replay
