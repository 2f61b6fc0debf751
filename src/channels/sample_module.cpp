#include "channels/sample_module.hpp"

namespace dataflow {

SampleModule::SampleModule(sc_core::sc_module_name const& name, DataflowCore& core)
    : sc_module(name), clock_(core, basename()), core_(core) {
    SC_HAS_PROCESS(SampleModule);
    SC_THREAD(run);
}

void SampleModule::run() {
    std::size_t const number = clock_.timing().index();
    for (std::size_t i = 0; i < core_.share().count; ++i) {
        clock_.begin_sample();
        if (number == core_.machine().begins)
            clock_.stamp();
        work(core_.share().first + i);
        if (number == core_.machine().ends) {
            clock_.stamp();
            clock_.end_sample();
        }
    }
}

}  // namespace dataflow
