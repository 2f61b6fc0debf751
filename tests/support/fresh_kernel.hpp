#pragma once
#include <memory>
#include <systemc>

namespace faster::testing {

/// A SystemC kernel in the place of the process's, which elaborates once: with one for each design a test runs as many
/// as it wants. What is elaborated with it has to be gone before it.
class FreshKernel {
  public:
    FreshKernel();
    ~FreshKernel();
    FreshKernel(FreshKernel const&) = delete;
    FreshKernel& operator=(FreshKernel const&) = delete;

  private:
    sc_core::sc_simcontext *current_before_, *default_before_;
    std::unique_ptr<sc_core::sc_simcontext> kernel_;
};

}  // namespace faster::testing
