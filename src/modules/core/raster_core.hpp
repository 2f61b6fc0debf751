#pragma once
#include <memory>
#include <optional>
#include <string>
#include <systemc>
#include <utility>

#include "channels/pixels_fifo.hpp"
#include "modules/area_reciprocal/area_reciprocal.hpp"
#include "modules/core/raster_core_description.hpp"
#include "modules/edge_map_builder/edge_map_buffers.hpp"
#include "modules/inlier_unit/depth_buffers.hpp"
#include "modules/observation_reader/observation_reader.hpp"
#include "modules/result_collector/result_collector.hpp"
#include "modules/sample_dispatcher/sample_dispatcher.hpp"
#include "modules/vertex_transform/vertex_transform.hpp"

namespace faster {

/// One raster core: picks its modules and joins them. The modules are the thesis's where the configuration asks for no
/// more, and variants of them where it does.
class RasterCore : public DataflowCore {
  public:
    /// `config` and `stimulus` must outlive the core.
    RasterCore(sc_core::sc_module_name const& name, AcceleratorConfig const& config, Stimulus const& stimulus,
               std::shared_ptr<Machine const> machine, CoreShare share, TimeBase const& time_base);

    void set_probe(SampleProbe* probe) { context_.probe = probe; }

    std::size_t results() const override { return result_collector_.results().size(); }
    Counters result(std::size_t i) const override;
    std::size_t most_samples_ahead() const override;
    std::uint64_t tokens_in_use() const override { return context_.sweeps_touched() ? 2 : 1; }
    std::unique_ptr<recording::MemoryActivity> memory_activity() const override;

  private:
    using Module = std::unique_ptr<sc_core::sc_module>;
    Module make_rasterizer();
    Module make_edge_map_builder();
    Module make_inlier_unit();
    Module make_edge_map_output();
    Module make_inlier_sweep();
    template <class Rasterizer> void join_rasterizer(Rasterizer& rasterizer);
    template <class InlierUnit> void join_inlier_unit(InlierUnit& unit);
    template <class Sweep> void join_scoring(Sweep& sweep);
    bool has(char const* module) const { return machine().processes[machine().process(module)].is_present; }
    bool scans_groups() const { return context_.config.rasterizer.lanes > 1; }
    std::size_t sweep_lanes() const { return context_.window_rows().lanes(); }
    /// Where always the window is swept, no token says so.
    template <class FullBuffer> std::size_t fields_of() const {
        return TokenFields<FullBuffer>::layout.size() - (context_.sweeps_touched() ? 0 : region_fields);
    }

    std::size_t counters() const { return counters_of(counts_hidden(context_.config.inlier_unit)); }

    CoreContext context_;

    // What a design does not have is bound to nothing.
    ClockedFifo<SampleHeader> sample_vertex_{"sample_vertex", fifo_timing("sample_vertex")};
    ClockedFifo<SampleHeader> sample_raster_{"sample_raster", fifo_timing("sample_raster")};
    ClockedFifo<SampleHeader> sample_observation_{"sample_observation", fifo_timing("sample_observation")};
    ClockedFifo<VertexCode> vertex_{"vertex", fifo_timing("vertex")};
    ClockedFifo<std::int64_t> area_{"area", fifo_timing("area")};
    ClockedFifo<std::uint64_t> area_reciprocal_{"area_reciprocal", fifo_timing("area_reciprocal")};
    ClockedFifo<Command> command_{"command", fifo_timing("command")};
    PixelsFifo<std::int64_t, DepthGroup> fragment_depth_{"fragment_depth", fifo_timing("fragment_depth"),
                                                         scans_groups()};
    PixelsFifo<FragmentIndex, PixelGroup> fragment_index_{"fragment_index", fifo_timing("fragment_index"),
                                                          scans_groups()};
    PixelsFifo<EdgeToken, PixelGroup> edge_token_{"edge_token", fifo_timing("edge_token"), scans_groups()};
    ClockedFifo<std::uint8_t> edge_map_{"edge_map", fifo_timing("edge_map"), sweep_lanes()};
    ClockedFifo<std::uint16_t> observed_depth_{"observed_depth", fifo_timing("observed_depth"), sweep_lanes()};
    ClockedFifo<std::uint8_t> observed_edge_{"observed_edge", fifo_timing("observed_edge"), sweep_lanes()};
    ClockedFifo<SampleCounters> result_{"result", fifo_timing("result"), 1, counters()};
    ClockedFifo<FragmentIndex> region_{"region", fifo_timing("region")};
    ClockedFifo<std::uint64_t> valid_depth_{"valid_depth", fifo_timing("valid_depth")};
    ClockedFifo<FullMaps> map_full_{"map_full", fifo_timing("map_full"), 1, fields_of<FullMaps>()};
    ClockedFifo<BufferNumber> map_free_{"map_free", fifo_timing("map_free")};
    ClockedFifo<FullDepthBuffer> depth_full_{"depth_full", fifo_timing("depth_full"), 1, fields_of<FullDepthBuffer>()};
    ClockedFifo<BufferNumber> depth_free_{"depth_free", fifo_timing("depth_free")};

    // Of variants, whose processes hand them over.
    std::optional<EdgeMapBuffers> edge_map_buffers_;
    std::optional<DepthBuffers> depth_buffers_;

    SampleDispatcher sample_dispatcher_;
    VertexTransform vertex_transform_;
    Module rasterizer_;
    AreaReciprocal area_reciprocal_unit_;
    Module edge_map_builder_;  ///< null in flow fpga_grip
    ObservationReader observation_reader_;
    Module inlier_unit_;
    ResultCollector result_collector_;
    Module edge_map_output_;  ///< null with one buffer
    Module inlier_sweep_;     ///< null with one buffer
};

}  // namespace faster
