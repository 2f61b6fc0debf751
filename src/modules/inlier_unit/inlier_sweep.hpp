#pragma once
#include <systemc>

#include "channels/port_binding.hpp"
#include "faster/data/buffer_tokens.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/inlier_unit/depth_buffers.hpp"
#include "modules/inlier_unit/scoring.hpp"

namespace faster {

/// Compares the depth buffer that the inlier unit has drawn with the observation, while that draws the next sample;
/// only with accelerator.inlier_unit.buffers 2.
///   in    depth_full_in   the buffer that is drawn, and what was counted meanwhile; sweep_region touched: and the
///                         touched region
///         edge_map_in, observed_depth_in, observed_edge_in  W x W each, or the region's, row-major, `sweep_lanes`
///                                                           pixels per token
///   out   depth_free_out  the other buffer, which has been swept
///         result_out      one set of counters per sample
///   time  one step; in flow fpga_grip loop `extract`; loop `sweep`; one step
/// Source: this project; docs/variants.md.
class InlierSweep : public CoreModule {
  public:
    sc_core::sc_fifo_in<FullDepthBuffer> depth_full_in{"depth_full_in"};
    sc_core::sc_fifo_out<BufferNumber> depth_free_out{"depth_free_out"};
    OptionalFifoIn<std::uint8_t> edge_map_in{"edge_map_in"};  ///< unbound in flow fpga_grip
    sc_core::sc_fifo_in<std::uint16_t> observed_depth_in{"observed_depth_in"};
    sc_core::sc_fifo_in<std::uint8_t> observed_edge_in{"observed_edge_in"};
    sc_core::sc_fifo_out<SampleCounters> result_out{"result_out"};

    static ModuleDescription describe(AcceleratorConfig const& config);

    InlierSweep(sc_core::sc_module_name const& name, CoreContext const& core, DepthBuffers& buffers);

  private:
    void connect() override;
    void work(std::size_t i) override;
    FullDepthBuffer take();

    DepthBuffers& buffers_;
    Scoring scoring_;
};

}  // namespace faster
