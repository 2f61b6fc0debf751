#include "channels/sample_module.hpp"

#include <exception>
#include <new>
#include <string>

#include "dataflow/base/held_signals.hpp"
#include "dataflow/base/input_error.hpp"

namespace dataflow {

namespace {
/// Of the exception at hand: itself, or the mistake of the design that it is where work() has thrown it.
std::exception_ptr as_mistake(std::string const& module, std::size_t sample) {
    auto const mistake = [&](std::string const& what) {
        return std::make_exception_ptr(InputError("module " + module + " has thrown " + what + " in sample " +
                                                  std::to_string(sample) + ", expected work() to return"));
    };
    try {
        throw;
    } catch (InputError const&) {
    } catch (std::bad_alloc const&) {
    } catch (processes::Interrupted const&) {
    } catch (std::exception const& error) {
        return mistake("\"" + std::string(error.what()) + "\"");
    } catch (...) {
        return mistake("what is no std::exception");
    }
    return std::current_exception();
}
}  // namespace

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
        core_.fail(clock_.timing().index(), as_mistake(clock_.timing().name(), sample_));
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
