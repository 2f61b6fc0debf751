#pragma once
#include <systemc>

#include "channels/pixels_fifo.hpp"
#include "channels/token_loop.hpp"
#include "faster/data/buffer_tokens.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/core/depth.hpp"
#include "modules/inlier_unit/depth_buffers.hpp"
#include "modules/inlier_unit/fragment_drawing.hpp"
#include "modules/inlier_unit/scoring.hpp"

namespace faster {

/// What keys make of the InlierUnit: fragments of several pixels, one loop for all of a sample's, other ways to clear
/// and to sweep, the touched region, extracted edges, hidden pixels. Ports and time are the InlierUnit's, but for:
///   in    fragment_index_in  sweep_region touched: after the fragments the corners of the touched region
///         edge_map_in        unbound in flow fpga_grip
///         edge_map_in, observed_depth_in, observed_edge_in  those of the region, `sweep_lanes` pixels of a row per
///         token
///   time  loop `fragment` once with fragment_loop flattened; in flow fpga_grip loop `extract` before `sweep`
/// With two buffers, InlierSweep does what comes after the drawing:
///   in    depth_free_in   the buffer of the next sample, instead of edge_map_in, observed_depth_in, observed_edge_in
///   out   depth_full_out  the drawn one and its region, instead of result_out
///   time  a step each instead of loops `extract` and `sweep`
class InlierUnitVariant : public CoreModule {
  public:
    sc_core::sc_fifo_in<std::uint64_t> area_reciprocal_in{"area_reciprocal_in"};
    PixelsIn<std::int64_t, DepthGroup> fragment_depth_in{"fragment_depth_in"};
    PixelsIn<FragmentIndex, PixelGroup> fragment_index_in{"fragment_index_in"};
    sc_core::sc_fifo_in<Command> command_in{"command_in"};
    OptionalFifoIn<std::uint8_t> edge_map_in{"edge_map_in"};  ///< unbound in flow fpga_grip, too
    OptionalFifoIn<std::uint16_t> observed_depth_in{"observed_depth_in"};
    OptionalFifoIn<std::uint8_t> observed_edge_in{"observed_edge_in"};
    OptionalFifoOut<SampleCounters> result_out{"result_out"};
    OptionalFifoIn<BufferNumber> depth_free_in{"depth_free_in"};        ///< bound with two buffers
    OptionalFifoOut<FullDepthBuffer> depth_full_out{"depth_full_out"};  ///< bound with two buffers

    /// Whether a core takes more than the InlierUnit.
    static bool is_needed(AcceleratorConfig const& config);
    static ModuleDescription describe(AcceleratorConfig const& config);

    InlierUnitVariant(sc_core::sc_module_name const& name, CoreContext const& core, DepthBuffers& buffers);

  private:
    void connect() override;
    void start() override;
    void work(std::size_t i) override;
    void clear();
    void draw_triangles();
    void draw_in_one_loop();
    void take_triangle(std::uint64_t& reciprocal, Command& command);
    void take_fragments(std::uint64_t reciprocal, Command& command);
    Command draw_fragments(std::uint64_t reciprocal, Command command);
    PixelBox turn_to_sweep();
    Corners read_region();
    FragmentIndex read_corner();
    void score(std::size_t sample);
    void hand_over();

    datapath::DepthUnit depth_unit_;
    DepthBuffers& buffers_;
    std::size_t buffer_ = 0;
    std::vector<std::uint16_t>* depth_buffer_ = nullptr;  ///< of the sample at hand
    Scoring scoring_;                                     ///< one buffer
    SampleCounters counters_;
    // Loop `fragment`, by what an iteration takes.
    TokenLoop<Reads<std::uint64_t, Command>> triangle_;
    TokenLoop<Reads<std::int64_t, FragmentIndex, Command>> fragment_;
    TokenLoop<Reads<DepthGroup, PixelGroup, Command>> group_;
    ClockedFifo<FragmentIndex>* fragment_index_ = nullptr;
    ClockedFifo<PixelGroup>* index_groups_ = nullptr;     ///< null: fragments come one by one
    ClockedFifo<SampleCounters>* result_ = nullptr;       ///< one buffer
    ClockedFifo<BufferNumber>* depth_free_ = nullptr;     ///< two buffers
    ClockedFifo<FullDepthBuffer>* depth_full_ = nullptr;  ///< two buffers
    WriteDistances* distances_ = nullptr;                 ///< told what the fragment loop does; mostly null
};

}  // namespace faster
