#pragma once
#include <cstddef>
#include <systemc>

#include "channels/dataflow_core.hpp"
#include "channels/process_clock.hpp"
#include "channels/tokens_of.hpp"

namespace dataflow {

/// A module with one process, which does its part of one sample after the other. The derived class says in work() what
/// that is; everything that all such modules do alike is done here. Its name is the one in its description.
///
/// What the last module ends with is the end of the sample: the last cycle that work() lets pass counts.
class SampleModule : public sc_core::sc_module {
  public:
    SampleModule(sc_core::sc_module_name const& name, DataflowCore& core);
    ProcessClock const& clock() const { return clock_; }

  protected:
    /// Sample number `sample` of the run. Time passes by the clock only, advance() and loops: SystemC's own wait() is
    /// not part of it. An access takes place within a cycle, which is part of the call if work() lets it pass; let one
    /// pass behind the last access. A call in which none passes takes no time: if it is the last of a sample, that ends
    /// with the cycle before, or in cycle 0.
    virtual void work(std::size_t sample) = 0;

    ProcessClock clock_;

  private:
    void end_of_elaboration() override { clock_.connect_all(); }
    void run();
    void work_on_all();

    DataflowCore& core_;
    std::size_t sample_ = 0;  ///< at hand
};

}  // namespace dataflow
