#pragma once
#include <memory>
#include <systemc>

#include "faster/parts.hpp"
#include "kernel/machine/core_share.hpp"
#include "modules/area_reciprocal.hpp"
#include "modules/edge_map_builder.hpp"
#include "modules/edge_map_output.hpp"
#include "modules/inlier_sweep.hpp"
#include "modules/inlier_unit.hpp"
#include "modules/observation_reader.hpp"
#include "modules/rasterizer.hpp"
#include "modules/result_collector.hpp"
#include "modules/sample_dispatcher.hpp"
#include "modules/vertex_transform.hpp"

namespace faster {

/// One raster core: the dataflow region of SPEC section 1. Wiring only.
class RasterCore : public sc_core::sc_module {
  public:
    RasterCore(sc_core::sc_module_name const& name, AcceleratorConfig const& config, Stimulus const& stimulus,
               CoreShare share, TimeBase const& time_base);

    Parts parts() const { return Parts(context_.config); }
    CoreShare share() const { return {context_.first_sample, context_.sample_count}; }
    void set_probe(SampleProbe* probe) { context_.probe = probe; }
    void set_progress(std::function<void()> progress) { context_.progress = std::move(progress); }
    void on_sample_begins(std::function<void(std::size_t)> call) { context_.sample_begins.push_back(std::move(call)); }
    /// Calls back whenever a process begins its next sample.
    void on_process_begins(std::function<void(ModuleId)> call) { context_.process_begins.push_back(std::move(call)); }
    /// Calls back when the core is wired up and nothing has happened yet.
    void on_start(std::function<void()> call) { starts_.push_back(std::move(call)); }
    /// In the order of FifoId.
    std::vector<FifoChannel*> channels();
    /// Tokens of observed_depth per sample.
    std::size_t window_tokens() const { return context_.window_rows().tokens(); }
    /// Gives all operations logged so far their cycles, where the kernel does not do so (decoupled).
    void catch_up() {
        if (context_.time_base.engine == Engine::decoupled)
            timing_.resolve(false);
    }
    /// Makes this core begin when another has done its share.
    void run_after(RasterCore const& other) { context_.turn = &other.done_; }
    timing::CoreTiming& timing() { return timing_; }
    timing::CoreTiming const& timing() const { return timing_; }

  private:
    void start_of_simulation() override {
        for (auto const& call : starts_)
            call();
    }
    timing::FifoTiming& fifo_timing(FifoId id) { return timing_.add_fifo(fifo_shape_of(id)); }
    template <class Module, class Buffers> std::unique_ptr<Module> make_part(ModuleId id, Buffers& buffers);
    void bind_edge_maps();
    void bind_scoring();
    timing::FifoShape fifo_shape_of(FifoId id) const;
    bool scans_groups() const { return context_.config.rasterizer.lanes > 1; }
    std::size_t sweep_lanes() const { return context_.window_rows().lanes(); }
    /// Where always the window is swept, no token says so.
    template <class FullBuffer> std::size_t fields_of() const {
        return TokenFields<FullBuffer>::layout.size() - (context_.sweeps_touched() ? 0 : region_fields);
    }

    std::vector<std::function<void()>> starts_;
    timing::CoreTiming timing_;
    sc_core::sc_event done_{"done"};
    CoreContext context_;

    // In the order of FifoId: the tables of the report rely on it. What a design does not have is bound to nothing.
    ClockedFifo<SampleHeader> sample_vertex_{"sample_vertex", fifo_timing(FifoId::sample_vertex)};
    ClockedFifo<SampleHeader> sample_raster_{"sample_raster", fifo_timing(FifoId::sample_raster)};
    ClockedFifo<SampleHeader> sample_observation_{"sample_observation", fifo_timing(FifoId::sample_observation)};
    ClockedFifo<VertexCode> vertex_{"vertex", fifo_timing(FifoId::vertex)};
    ClockedFifo<std::int64_t> area_{"area", fifo_timing(FifoId::area)};
    ClockedFifo<std::uint64_t> area_reciprocal_{"area_reciprocal", fifo_timing(FifoId::area_reciprocal)};
    ClockedFifo<Command> command_{"command", fifo_timing(FifoId::command)};
    PixelsFifo<std::int64_t, DepthGroup> fragment_depth_{"fragment_depth", fifo_timing(FifoId::fragment_depth),
                                                         scans_groups()};
    PixelsFifo<FragmentIndex, PixelGroup> fragment_index_{"fragment_index", fifo_timing(FifoId::fragment_index),
                                                          scans_groups()};
    PixelsFifo<EdgeToken, PixelGroup> edge_token_{"edge_token", fifo_timing(FifoId::edge_token), scans_groups()};
    ClockedFifo<std::uint8_t> edge_map_{"edge_map", fifo_timing(FifoId::edge_map), sweep_lanes()};
    ClockedFifo<std::uint16_t> observed_depth_{"observed_depth", fifo_timing(FifoId::observed_depth), sweep_lanes()};
    ClockedFifo<std::uint8_t> observed_edge_{"observed_edge", fifo_timing(FifoId::observed_edge), sweep_lanes()};
    ClockedFifo<SampleCounters> result_{"result", fifo_timing(FifoId::result)};
    ClockedFifo<FragmentIndex> region_{"region", fifo_timing(FifoId::region)};
    ClockedFifo<std::uint64_t> valid_depth_{"valid_depth", fifo_timing(FifoId::valid_depth)};
    ClockedFifo<FullMaps> map_full_{"map_full", fifo_timing(FifoId::map_full), 1, fields_of<FullMaps>()};
    ClockedFifo<BufferNumber> map_free_{"map_free", fifo_timing(FifoId::map_free)};
    ClockedFifo<FullDepthBuffer> depth_full_{"depth_full", fifo_timing(FifoId::depth_full), 1,
                                             fields_of<FullDepthBuffer>()};
    ClockedFifo<BufferNumber> depth_free_{"depth_free", fifo_timing(FifoId::depth_free)};

    EdgeMapBuffers edge_map_buffers_;
    DepthBuffers depth_buffers_;

  public:
    // In the order of ModuleId.
    SampleDispatcher sample_dispatcher;
    VertexTransform vertex_transform;
    Rasterizer rasterizer;
    AreaReciprocal area_reciprocal_unit;
    std::unique_ptr<EdgeMapBuilder> edge_map_builder;  ///< null in flow fpga_grip
    ObservationReader observation_reader;
    InlierUnit inlier_unit;
    ResultCollector result_collector;
    std::unique_ptr<EdgeMapOutput> edge_map_output;  ///< null with one buffer
    std::unique_ptr<InlierSweep> inlier_sweep;       ///< null with one buffer
};

}  // namespace faster
