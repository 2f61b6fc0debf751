#pragma once
#include <systemc>

#include "faster/data/buffer_tokens.hpp"
#include "modules/core/core_module.hpp"
#include "modules/edge_map_builder/edge_map_buffers.hpp"
#include "modules/edge_map_builder/edge_map_read_out.hpp"

namespace faster {

/// Reads out the maps that the edge map builder has finished, while that builds the next sample's; only with
/// accelerator.edge_map.buffers 2.
///   in    map_full_in   the buffer that holds the sample's maps; sweep_region touched: and the touched region
///   out   map_free_out  the other one, which has been read out
///         edge_map_out  W x W bits per sample, or those of the region, row-major, `sweep_lanes` bits of a row per
///         token
///   time  one step, loop `output`
/// Source: this project; docs/variants.md.
class EdgeMapOutput : public CoreModule {
  public:
    sc_core::sc_fifo_in<FullMaps> map_full_in{"map_full_in"};
    sc_core::sc_fifo_out<BufferNumber> map_free_out{"map_free_out"};
    sc_core::sc_fifo_out<std::uint8_t> edge_map_out{"edge_map_out"};

    static ModuleDescription describe(AcceleratorConfig const& config);

    EdgeMapOutput(sc_core::sc_module_name const& name, CoreContext const& core, EdgeMapBuffers& buffers);

  private:
    void connect() override;
    void work(std::size_t i) override;
    FullMaps take();

    EdgeMapBuffers& buffers_;
    EdgeMapReadOut read_out_;
};

}  // namespace faster
