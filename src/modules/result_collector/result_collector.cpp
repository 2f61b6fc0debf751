#include "modules/result_collector/result_collector.hpp"

#include "channels/port_binding.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/conditions.hpp"
#include "modules/core/memory_entries.hpp"

namespace faster {

ModuleDescription ResultCollector::describe(AcceleratorConfig const& config) {
    ModuleDescription module("result_collector");
    module.reads_from("result");
    module.reads_from("valid_depth").only_if(sweeps_touched_region(config));
    module.stores("result").brings("results of samples");
    return module;
}

void ResultCollector::start() {
    for (std::size_t i = 0; clock_.uses_memory() && i < core_.sample_count; ++i)
        clock_.tell_entry(result_entry(core_.config.memory_placement, i, core_.first_sample + i));
}

void ResultCollector::work(std::size_t /*i*/) {
    results_.push_back(receive());
    clock_.stamp();
    clock_.advance(1);
    clock_.end_sample();
}

SampleCounters ResultCollector::receive() {
    Step const step(clock_);
    clock_.access_memory();
    SampleCounters counters = result_in.read();
    if (core_.sweeps_touched())
        counters.valid_depth = valid_depth_in->read();
    return counters;
}

}  // namespace faster
