#include "channels/sample_module.hpp"

#include <exception>

namespace dataflow {

SampleModule::SampleModule(sc_core::sc_module_name const& name, DataflowCore& core)
    : sc_module(name), clock_(core, basename()), core_(core) {
    SC_HAS_PROCESS(SampleModule);
    SC_THREAD(run);
}

/// What is wrong is told when nothing moves any more: an exception cannot leave a process of the SystemC kernel.
void SampleModule::run() {
    try {
        work_on_all();
    } catch (std::exception const&) {
        core_.fail(clock_.timing().index(), std::current_exception());
    }
}

void SampleModule::work_on_all() {
    std::size_t const number = clock_.timing().index();
    for (std::size_t i = 0; i < core_.share().count; ++i) {
        clock_.begin_sample();
        clock_.begin_region();
        if (number == core_.machine().begins && number != core_.machine().ends)
            clock_.stamp();
        clock_.begin_call();
        work(core_.share().first + i);
        if (number == core_.machine().ends)
            clock_.stamp();
        clock_.end_call();
        if (number == core_.machine().ends)
            clock_.end_sample();
    }
    clock_.end_calls();
}

}  // namespace dataflow
