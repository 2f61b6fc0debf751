#include "support/fresh_kernel.hpp"

#include <cstdlib>

#include "faster/dataflow_names.hpp"

namespace faster::testing {

FreshKernel::FreshKernel()
    : current_before_(sc_core::sc_curr_simcontext),
      default_before_(sc_core::sc_default_global_context),
      kernel_(std::make_unique<sc_core::sc_simcontext>()) {
    setenv("SYSTEMC_DISABLE_COPYRIGHT_MESSAGE", "1", 1);
    sc_core::sc_curr_simcontext = kernel_.get();
    sc_core::sc_default_global_context = kernel_.get();
}

FreshKernel::~FreshKernel() {
    kernel_.reset();
    sc_core::sc_curr_simcontext = current_before_;
    sc_core::sc_default_global_context = default_before_;
}

}  // namespace faster::testing
