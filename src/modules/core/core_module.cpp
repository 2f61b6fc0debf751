#include "modules/core/core_module.hpp"

namespace faster {

CoreModule::CoreModule(sc_core::sc_module_name const& name, CoreContext const& core) : CoreModule(name, core, name) {}

CoreModule::CoreModule(sc_core::sc_module_name const& name, CoreContext const& core, char const* described)
    : sc_module(name), core_(core), clock_(core.core, described) {
    SC_HAS_PROCESS(CoreModule);
    SC_THREAD(run);
}

void CoreModule::end_of_elaboration() {
    clock_.connect_all();
    connect();
}

void CoreModule::run() {
    start();
    for (std::size_t i = 0; i < core_.sample_count; ++i) {
        clock_.begin_sample();
        work(i);
    }
}

}  // namespace faster
