#pragma once
#include <systemc>
#include <vector>

#include "channels/token_loop.hpp"
#include "faster/data/token_fields.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/core/depth.hpp"
#include "modules/inlier_unit/fragment_drawing.hpp"
#include "modules/inlier_unit/window_sweep.hpp"

namespace faster {

/// Keeps the depth buffer of a sample, then compares it with the observation and counts what agrees: thesis 4.1.3 and
/// A.3, and nothing else. InlierUnitVariant has what keys add.
///   in    command_in, area_reciprocal_in, fragment_depth_in, fragment_index_in  while the sample is rasterized
///         edge_map_in, observed_depth_in, observed_edge_in                      W x W each, row-major, afterwards
///   out   result_out  one set of counters per sample
///   time  loop `clear`; per triangle one step and loop `fragment`; loop `sweep`
class InlierUnit : public CoreModule {
  public:
    sc_core::sc_fifo_in<std::uint64_t> area_reciprocal_in{"area_reciprocal_in"};
    sc_core::sc_fifo_in<std::int64_t> fragment_depth_in{"fragment_depth_in"};
    sc_core::sc_fifo_in<FragmentIndex> fragment_index_in{"fragment_index_in"};
    sc_core::sc_fifo_in<Command> command_in{"command_in"};
    sc_core::sc_fifo_in<std::uint8_t> edge_map_in{"edge_map_in"};
    sc_core::sc_fifo_in<std::uint16_t> observed_depth_in{"observed_depth_in"};
    sc_core::sc_fifo_in<std::uint8_t> observed_edge_in{"observed_edge_in"};
    sc_core::sc_fifo_out<SampleCounters> result_out{"result_out"};

    static ModuleDescription describe(AcceleratorConfig const& config);

    InlierUnit(sc_core::sc_module_name const& name, CoreContext const& core);

  private:
    void connect() override;
    void work(std::size_t i) override;
    void clear();
    void draw_triangles();
    Command draw_fragments(std::uint64_t reciprocal, Command command);
    void sweep();

    datapath::DepthUnit depth_unit_;
    datapath::WindowSweep window_sweep_;
    std::vector<std::uint16_t> depth_buffer_;
    SampleCounters counters_;
    TokenLoop<Reads<std::int64_t, FragmentIndex, Command>> fragment_;
    TokenLoop<Reads<std::uint8_t, std::uint16_t, std::uint8_t>> sweep_;
    WriteDistances* distances_ = nullptr;  ///< of what fragments access: see with_watcher()
};

}  // namespace faster
