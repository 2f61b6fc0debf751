#pragma once
#include <systemc>
#include <vector>

#include "channels/port_binding.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"

namespace faster {

/// Takes the samples' counters to the host.
///   in    result_in       one per sample
///         valid_depth_in  sweep_region touched: one per sample, which takes its place among the counters
///   time  one step per sample
/// Source: docs/timing-model.md#sources-of-time.
class ResultCollector : public CoreModule {
  public:
    sc_core::sc_fifo_in<SampleCounters> result_in{"result_in"};
    OptionalFifoIn<std::uint64_t> valid_depth_in{"valid_depth_in"};  ///< unbound unless touched

    static ModuleDescription describe(AcceleratorConfig const& config);

    using CoreModule::CoreModule;
    /// By sample of this core.
    std::vector<SampleCounters> const& results() const { return results_; }

  private:
    void start() override;
    void work(std::size_t i) override;
    SampleCounters receive();

    std::vector<SampleCounters> results_;
};

}  // namespace faster
