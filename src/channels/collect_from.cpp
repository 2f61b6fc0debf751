#include "channels/collect_from.hpp"

#include <string>

#include "channels/taping.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/replay/collect.hpp"

namespace dataflow {
namespace {

/// Of a core that has done all its samples.
void require_results(DataflowCore const& core) {
    if (core.results() != core.share().count)
        throw InputError(std::string(core.name()) + " has " + std::to_string(core.results()) + " results of " +
                         std::to_string(core.share().count) + " samples, expected one add_result() for each");
}

}  // namespace

RunStatistics collect_from(DataflowAccelerator& accelerator, std::size_t first, std::size_t end, Cycles others) {
    std::vector<std::vector<Counters>> results;
    std::vector<replay::FinishedCore> cores;
    if (accelerator.memory() != nullptr)
        accelerator.memory()->go_on(true);
    for (std::size_t i = first; i < end; ++i) {
        DataflowCore& core = *accelerator.cores()[i];
        core.timing().resolve();
        core.throw_error();
        results.push_back(all_results(core));
        results.back().resize(core.share().count);  // there are fewer if it is stuck
        cores.push_back({core.share(), core.timing(), results.back().data()});
    }
    RunStatistics run =
        replay::collect(cores, accelerator.machine(), accelerator.memory(), accelerator.loaded(), others);
    if (!run.deadlocked())
        for (std::size_t i = first; i < end; ++i)
            require_results(*accelerator.cores()[i]);
    return run;
}

}  // namespace dataflow
