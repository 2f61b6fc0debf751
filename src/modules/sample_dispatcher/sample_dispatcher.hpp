#pragma once
#include <systemc>

#include "faster/data/tokens.hpp"
#include "modules/core/core_module.hpp"

namespace faster {

/// Starts the samples of a core, one after the other: tells the vertex, raster and observation stages what to work on.
///   out   sample_vertex_out, sample_raster_out, sample_observation_out: one header per sample each, together
///   time  one step per sample
/// Source: docs/function.md#samples-and-cores, docs/timing-model.md#sources-of-time.
class SampleDispatcher : public CoreModule {
  public:
    sc_core::sc_fifo_out<SampleHeader> sample_vertex_out{"sample_vertex_out"};
    sc_core::sc_fifo_out<SampleHeader> sample_raster_out{"sample_raster_out"};
    sc_core::sc_fifo_out<SampleHeader> sample_observation_out{"sample_observation_out"};

    static ModuleDescription describe();

    using CoreModule::CoreModule;

  private:
    void start() override;
    void work(std::size_t i) override;
};

}  // namespace faster
