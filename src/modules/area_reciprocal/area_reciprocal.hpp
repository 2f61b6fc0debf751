#pragma once
#include <systemc>

#include "faster/data/tokens.hpp"
#include "modules/core/core_module.hpp"

namespace faster {

/// Divides once per drawn triangle, so that no fragment has to.
///   in    area_in             per triangle: twice its area, 0 or negative if it is not drawn
///   out   area_reciprocal_out per drawn triangle: code of 1 / area
///   time  flushing pipeline, one area per cycle; a result leaves write_latency cycles after its issue
/// Source: docs/function.md#formats, docs/timing-model.md#a-flushing-pipeline-that-freezes.
class AreaReciprocal : public CoreModule {
  public:
    sc_core::sc_fifo_in<std::int64_t> area_in{"area_in"};
    sc_core::sc_fifo_out<std::uint64_t> area_reciprocal_out{"area_reciprocal_out"};

    static ModuleDescription describe(AcceleratorConfig const& config);

    /// SystemC has a FIFO of the module's name.
    AreaReciprocal(sc_core::sc_module_name const& name, CoreContext const& core)
        : CoreModule(name, core, "area_reciprocal") {}

  private:
    void work(std::size_t i) override;
};

}  // namespace faster
