#include "channels/sample_module.hpp"

#include <string>

#include "dataflow/base/as_mistake.hpp"

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
    } catch (sc_core::sc_unwind_exception const&) {
        throw;  // the kernel ends the process
    } catch (...) {
        core_.fail(clock_.timing().index(), as_mistake([this](char const* what) {
                       return "module " + clock_.timing().name() + " has thrown " +
                              (what != nullptr ? "\"" + std::string(what) + "\"" : "what is no std::exception") +
                              " in sample " + std::to_string(sample_) + ", expected work() to return";
                   }));
    }
}

void SampleModule::work_on_all() {
    std::size_t const number = clock_.timing().index();
    for (std::size_t i = 0; i < core_.share().count && !core_.is_left(); ++i) {
        clock_.begin_sample();
        clock_.begin_region();
        if (number == core_.machine().begins && number != core_.machine().ends)
            clock_.stamp();
        clock_.begin_call();
        sample_ = core_.share().first + i;
        work(sample_);
        if (number == core_.machine().ends)
            clock_.stamp();
        clock_.end_call();
        if (number == core_.machine().ends)
            clock_.end_sample();
    }
    clock_.end_calls();
}

}  // namespace dataflow
