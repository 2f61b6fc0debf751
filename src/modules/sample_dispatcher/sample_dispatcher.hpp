#pragma once
#include <systemc>

#include "faster/data/tokens.hpp"
#include "modules/core/core_context.hpp"

namespace faster {

/// Starts the samples of a core, one after the other: tells the vertex, raster and observation stages what to work on.
///   out   sample_vertex_out, sample_raster_out, sample_observation_out: one header per sample each, together
///   time  one step per sample
/// Source: docs/function.md#samples-and-cores, docs/timing-model.md#sources-of-time.
class SampleDispatcher : public sc_core::sc_module {
  public:
    sc_core::sc_fifo_out<SampleHeader> sample_vertex_out{"sample_vertex_out"};
    sc_core::sc_fifo_out<SampleHeader> sample_raster_out{"sample_raster_out"};
    sc_core::sc_fifo_out<SampleHeader> sample_observation_out{"sample_observation_out"};

    static ModuleDescription describe();

    SC_HAS_PROCESS(SampleDispatcher);
    SampleDispatcher(sc_core::sc_module_name const& name, CoreContext const& core);

  private:
    void end_of_elaboration() override;
    void run();

    CoreContext const& core_;
    ProcessClock clock_;
};

}  // namespace faster
