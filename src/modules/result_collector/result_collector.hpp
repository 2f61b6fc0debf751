#pragma once
#include <systemc>
#include <vector>

#include "channels/port_binding.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"

namespace faster {

/// Takes the samples' counters to the host.
///   in    result_in       one per sample
///         valid_depth_in  sweep_region touched: one per sample, which takes its place among the counters
///   time  one step per sample
/// Source: docs/timing-model.md#sources-of-time.
class ResultCollector : public sc_core::sc_module {
  public:
    sc_core::sc_fifo_in<SampleCounters> result_in{"result_in"};
    OptionalFifoIn<std::uint64_t> valid_depth_in{"valid_depth_in"};  ///< unbound unless touched

    static ModuleDescription describe(AcceleratorConfig const& config);

    SC_HAS_PROCESS(ResultCollector);
    ResultCollector(sc_core::sc_module_name const& name, CoreContext const& core);
    /// By sample of this core.
    std::vector<SampleCounters> const& results() const { return results_; }

  private:
    void end_of_elaboration() override;
    void run();
    SampleCounters receive();

    CoreContext const& core_;
    ProcessClock clock_;
    std::vector<SampleCounters> results_;
};

}  // namespace faster
