#include "modules/result_collector.hpp"

#include "channels/port_binding.hpp"

namespace faster {

ResultCollector::ResultCollector(sc_core::sc_module_name const& name, CoreContext const& core)
    : sc_module(name), core_(core), clock_(core.timing, basename(), core.time_base) {
    SC_THREAD(run);
}

void ResultCollector::end_of_elaboration() {
    clock_.connect_reads(channel_of(result_in));
    if (core_.sweeps_touched())
        clock_.connect_reads(*channel_of(valid_depth_in));
}

void ResultCollector::run() {
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        core_.begin_sample(ModuleId::result_collector);
        results_.push_back(receive());
        clock_.stamp();
        clock_.advance(1);
        clock_.resolve();  // all of the sample is known now: a good moment to give it its cycles
        if (core_.progress)
            core_.progress();
    }
    core_.done->notify(sc_core::SC_ZERO_TIME);
}

SampleCounters ResultCollector::receive() {
    if (!core_.sweeps_touched()) {
        clock_.here();
        return result_in.read();
    }
    Step const step(clock_);
    SampleCounters counters = result_in.read();
    counters.valid_depth = valid_depth_in->read();
    return counters;
}

}  // namespace faster
