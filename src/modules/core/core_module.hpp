#pragma once
#include <cstddef>
#include <systemc>

#include "channels/process_clock.hpp"
#include "modules/core/core_context.hpp"

namespace faster {

/// A module of the raster core: one process, which does its part of one sample after the other. The derived class says
/// in work() what that is; everything that all of them do alike is done here.
class CoreModule : public sc_core::sc_module {
  public:
    /// Its name is the one in its description, unless that is `described`.
    CoreModule(sc_core::sc_module_name const& name, CoreContext const& core);
    CoreModule(sc_core::sc_module_name const& name, CoreContext const& core, char const* described);

  protected:
    /// Its channels are there, and its clock knows them.
    virtual void connect() {}
    /// Before the first sample.
    virtual void start() {}
    /// The i-th sample of the core has begun.
    virtual void work(std::size_t i) = 0;

    CoreContext const& core_;
    ProcessClock clock_;

  private:
    void end_of_elaboration() override;
    void run();
};

}  // namespace faster
