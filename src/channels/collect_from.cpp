#include "channels/collect_from.hpp"

#include "channels/taping.hpp"
#include "dataflow/run/replay/collect.hpp"

namespace dataflow {

RunStatistics collect_from(DataflowAccelerator& accelerator, std::size_t first, std::size_t end, Cycles others) {
    std::vector<std::vector<Counters>> results;
    std::vector<replay::FinishedCore> cores;
    if (accelerator.memory() != nullptr)
        accelerator.memory()->go_on(true);
    for (std::size_t i = first; i < end; ++i) {
        DataflowCore& core = *accelerator.cores()[i];
        core.timing().resolve();
        results.push_back(all_results(core));
        cores.push_back({core.share(), core.timing(), results.back().data()});
    }
    return replay::collect(cores, accelerator.machine(), accelerator.memory(), accelerator.loaded(), others);
}

}  // namespace dataflow
