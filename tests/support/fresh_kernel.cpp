#include "support/fresh_kernel.hpp"

#include <cstdlib>

#include "faster/dataflow_names.hpp"

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/asan_interface.h>
#include <sys/syscall.h>
#include <unistd.h>

/// Processes that got stuck leave the sanitizer's marks on their stacks, which those of the next kernel would run into.
extern "C" int munmap(void* address, std::size_t bytes) noexcept {
    __asan_unpoison_memory_region(address, bytes);
    return static_cast<int>(syscall(SYS_munmap, address, bytes));
}
#endif

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
