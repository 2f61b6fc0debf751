#pragma once
#include <systemc>

#include "channels/clocked_fifo.hpp"
#include "channels/port_binding.hpp"
#include "common/tokens.hpp"
#include "datapath/near_edge_scan.hpp"
#include "datapath/zigzag_scan.hpp"
#include "modules/core_context.hpp"

namespace faster {

/// Scans a sample's triangles in zigzag and finds, while it does, which pixels they cover and where their edges are.
///   in    sample_raster_in, then three tokens of vertex_in per triangle
///   out   area_out            per triangle: twice its area, 0 if rejected
///         command_out         Triangle per drawn triangle, Fragment per covered pixel, End per sample
///         fragment_depth_out  z sum of each fragment
///         fragment_index_out  its pixel in the window
///         edge_token_out      flow faster: object and edge pixels (edge map algorithm threshold: pixels near an edge),
///         End per
///                             sample
///   time  per triangle 3 vertex steps, `setup`, one step to announce it; loop `scan`, one pixel or edge flush per
///   iteration
/// Source: thesis 4.1.1, 5.1 and A.1; SPEC sections 2 and 3.
class Rasterizer : public sc_core::sc_module {
  public:
    sc_core::sc_fifo_in<SampleHeader> sample_raster_in{"sample_raster_in"};
    sc_core::sc_fifo_in<VertexCode> vertex_in{"vertex_in"};
    sc_core::sc_fifo_out<std::int64_t> area_out{"area_out"};
    sc_core::sc_fifo_out<Command> command_out{"command_out"};
    sc_core::sc_fifo_out<std::int64_t> fragment_depth_out{"fragment_depth_out"};
    sc_core::sc_fifo_out<FragmentIndex> fragment_index_out{"fragment_index_out"};
    OptionalFifoOut<EdgeToken> edge_token_out{"edge_token_out"};  ///< unbound in flow fpga_grip

    SC_HAS_PROCESS(Rasterizer);
    Rasterizer(sc_core::sc_module_name const& name, CoreContext const& core);
    /// Its stamps are the cycles of the sample_raster reads: the samples' start cycles.
    ProcessClock const& clock() const { return clock_; }

  private:
    void end_of_elaboration() override;
    void run();
    void start_sample();
    TriangleCode receive_triangle();
    void announce(datapath::TriangleSetup const& setup);
    void draw(datapath::TriangleSetup const& setup);
    void scan(datapath::TriangleSetup const& setup);
    void send_line(datapath::ScanLine const& line);
    void send_run(datapath::ScanLine const& line);
    void send_tokens(datapath::ScanLine const& line, bool flushes, bool leaves);
    void send_edge(int row, int col);
    void scan_fragments(datapath::TriangleSetup const& setup);
    void send_fragments(datapath::ScanLine const& line);
    void scan_near_edges(datapath::TriangleSetup const& setup);
    void send_near_edge_line(datapath::NearEdgeLine const& line);
    void send_stretch(datapath::ScanLine const& line, datapath::Stretch const& stretch);
    void begin_burst(datapath::TriangleSetup const& setup);
    void hand_over();
    void end_burst();
    void end_sample();
    EdgeToken token_at(int row, int col, EdgeTokenKind kind) const;

    CoreContext const& core_;
    ProcessClock clock_;
    bool sends_near_edges_;                   ///< thesis 5.1's edge tokens, not A.1's
    std::array<std::int64_t, 3> thresholds_;  ///< in codes of edge values
    unsigned scan_loop_ = 0;
    // The clocked FIFOs behind the ports, for the scan's bursts.
    ClockedFifo<Command>* command_ = nullptr;
    ClockedFifo<std::int64_t>* fragment_depth_ = nullptr;
    ClockedFifo<FragmentIndex>* fragment_index_ = nullptr;
    ClockedFifo<EdgeToken>* edge_token_ = nullptr;  ///< null: no edges are looked for
    std::uint8_t fragment_ports_ = 0;               ///< of an iteration that finds a covered pixel
    std::uint8_t edge_port_ = 0;                    ///< of an iteration that sends an edge

    /// Where the scan at hand writes its next tokens, and which it has not handed over yet.
    struct Burst {
        std::int64_t const* first_depth = nullptr;
        EdgeToken const* first_token = nullptr;
        Command* command = nullptr;
        std::int64_t* depth = nullptr;
        FragmentIndex* index = nullptr;
        EdgeToken* token = nullptr;
    };
    Burst burst_;

    int row_offset_ = 0;  ///< of the window, kept within 16 bits
    int col_offset_ = 0;
    bool previous_inside_ = false;  ///< thesis: prev_in_triangle
    int previous_row_ = 0;
    int previous_col_ = 0;
};

}  // namespace faster
