#pragma once
#include <optional>
#include <systemc>

#include "channels/clocked_fifo.hpp"
#include "channels/pixels_fifo.hpp"
#include "common/tokens.hpp"
#include "datapath/depth.hpp"
#include "datapath/window_sweep.hpp"
#include "modules/core_context.hpp"
#include "modules/edge_extractor.hpp"

namespace faster {

/// Keeps the depth buffer of a sample, then compares it with the observation and counts what agrees.
///   in    command_in, area_reciprocal_in, fragment_depth_in, fragment_index_in  while the sample is rasterized
///         fragment_index_in  sweep_region touched: then the corners of the touched region
///         edge_map_in, observed_depth_in, observed_edge_in                      W x W each, or the region's,
///         row-major, afterwards,
///                                                               `sweep_lanes` pixels of a row per token
///   out   result_out  one set of counters per sample
///   time  loop `clear`; per triangle one step and loop `fragment`, or one loop `fragment` for all; in flow fpga_grip
///   loop
///         `extract`; loop `sweep`
/// Source: thesis 4.1.3 and A.3; SPEC sections 2 and 3.
class InlierUnit : public sc_core::sc_module {
  public:
    sc_core::sc_fifo_in<std::uint64_t> area_reciprocal_in{"area_reciprocal_in"};
    PixelsIn<std::int64_t, DepthGroup> fragment_depth_in{"fragment_depth_in"};
    PixelsIn<FragmentIndex, PixelGroup> fragment_index_in{"fragment_index_in"};
    sc_core::sc_fifo_in<Command> command_in{"command_in"};
    OptionalFifoIn<std::uint8_t> edge_map_in{"edge_map_in"};  ///< unbound in flow fpga_grip
    sc_core::sc_fifo_in<std::uint16_t> observed_depth_in{"observed_depth_in"};
    sc_core::sc_fifo_in<std::uint8_t> observed_edge_in{"observed_edge_in"};
    sc_core::sc_fifo_out<SampleCounters> result_out{"result_out"};

    SC_HAS_PROCESS(InlierUnit);
    InlierUnit(sc_core::sc_module_name const& name, CoreContext const& core);
    ProcessClock const& clock() const { return clock_; }

  private:
    void end_of_elaboration() override;
    void run();
    void clear();
    void draw_triangles();
    void draw_in_one_loop();
    void take_triangle(std::uint64_t& reciprocal, Command& command);
    void take_fragments(std::uint64_t reciprocal, Command& command);
    Command draw_fragments(std::uint64_t reciprocal, Command command);
    std::size_t draw_burst(std::uint64_t reciprocal, Command& command);
    void take_groups(std::uint64_t reciprocal, Command& command);
    std::size_t draw_groups(std::uint64_t reciprocal, Command& command);
    unsigned draw_group(std::uint64_t reciprocal, DepthGroup const& depths, PixelGroup const& pixels);
    PixelBox turn_to_sweep();
    FragmentIndex read_corner();
    void sweep(PixelBox const& box);
    void sweep_rows(LaneRows const& rows);
    void forget(PixelBox const& box);

    CoreContext const& core_;
    ProcessClock clock_;
    datapath::DepthUnit depth_unit_;
    datapath::WindowSweep window_sweep_;
    std::optional<EdgeExtractor> edge_extractor_;  ///< flow fpga_grip
    std::vector<std::uint16_t> depth_buffer_;      ///< W x W, row-major
    SampleCounters counters_;
    ClockedFifo<std::uint64_t>* area_reciprocal_ = nullptr;
    ClockedFifo<std::int64_t>* fragment_depth_ = nullptr;  ///< null: fragments come in groups
    ClockedFifo<FragmentIndex>* fragment_index_ = nullptr;
    ClockedFifo<DepthGroup>* depth_groups_ = nullptr;
    ClockedFifo<PixelGroup>* index_groups_ = nullptr;
    ClockedFifo<Command>* command_ = nullptr;
    ClockedFifo<std::uint8_t>* edge_map_ = nullptr;  ///< null: edges are extracted
    std::uint8_t triangle_ports_ = 0;
    std::uint8_t fragment_ports_ = 0;
    std::uint8_t sweep_ports_ = 0;
    unsigned clear_loop_ = 0;
    unsigned fragment_loop_ = 0;
    unsigned sweep_loop_ = 0;
};

}  // namespace faster
