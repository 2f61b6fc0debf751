#pragma once
#include <deque>
#include <optional>
#include <systemc>

#include "channels/clocked_fifo.hpp"
#include "channels/pixels_fifo.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/inlier_unit/touched_box.hpp"
#include "modules/rasterizer/grouped_line.hpp"
#include "modules/rasterizer/near_edge_scan.hpp"
#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster {

/// Scans a sample's triangles in zigzag and finds, while it does, which pixels they cover and where their edges are.
///
/// Reads
///   - sample_raster_in: a header per sample
///   - vertex_in: three per triangle
///
/// Writes
///   - area_out: per triangle twice its area, 0 if rejected
///   - command_out: Triangle per drawn triangle, Fragment per covered pixel, End per sample
///   - fragment_depth_out: z sum of each fragment
///   - fragment_index_out: the pixel of each fragment in the window
///   - edge_token_out (flow faster): object and edge pixels (algorithm threshold: pixels near an edge), and End
///   - region_out (sweep_region touched): first and last pixel of the box that the sample can have changed; both also
///     follow End in fragment_index_out and edge_token_out
///
/// With several lanes, fragment_depth_out, fragment_index_out and edge_token_out carry groups: the covered pixels of
/// `lanes` adjacent ones.
///
/// Time: per triangle three vertex steps, `setup`, and a step to announce it; loop `scan` with a pixel, group or edge
/// flush per iteration. With setup_overlap one loop `scan` per sample, whose iterations also read vertices and announce
/// triangles.
///
/// Source: thesis 4.1.1, 5.1 and A.1; docs/function.md#rasterizer, docs/timing-model.md#sources-of-time; setup_overlap
/// and the scans but zigzag: this project.
class Rasterizer : public sc_core::sc_module {
  public:
    sc_core::sc_fifo_in<SampleHeader> sample_raster_in{"sample_raster_in"};
    sc_core::sc_fifo_in<VertexCode> vertex_in{"vertex_in"};
    sc_core::sc_fifo_out<std::int64_t> area_out{"area_out"};
    sc_core::sc_fifo_out<Command> command_out{"command_out"};
    PixelsOut<std::int64_t, DepthGroup> fragment_depth_out{"fragment_depth_out"};
    PixelsOut<FragmentIndex, PixelGroup> fragment_index_out{"fragment_index_out"};
    PixelsOut<EdgeToken, PixelGroup> edge_token_out{"edge_token_out"};  ///< unbound in flow fpga_grip
    OptionalFifoOut<FragmentIndex> region_out{"region_out"};            ///< unbound unless touched

    static ModuleDescription describe(AcceleratorConfig const& config);

    SC_HAS_PROCESS(Rasterizer);
    Rasterizer(sc_core::sc_module_name const& name, CoreContext const& core);
    /// Its stamps are the cycles of the sample_raster reads: the samples' start cycles.
    ProcessClock const& clock() const { return clock_; }

  private:
    void end_of_elaboration() override;
    void run();
    void start_sample();
    void draw_one_by_one(std::uint32_t triangles);
    TriangleCode receive_triangle();
    void announce(datapath::TriangleSetup const& setup);

    /// Draws a triangle's box in a loop; `Lines` is how it walks, `Ahead` whether its iterations do more than that.
    using Scan = void (Rasterizer::*)(datapath::TriangleSetup const& setup);
    template <bool Ahead> Scan configured_scan() const;
    template <class Lines, bool Ahead> void scan(datapath::TriangleSetup const& setup);
    template <class Lines, bool Ahead> void send_line(datapath::ScanLine const& line);
    template <class Lines, bool Ahead> void send_run(datapath::ScanLine const& line);
    void send_tokens(datapath::ScanLine const& line, bool flushes, bool leaves);
    template <bool Ahead> void send_edge(int row, int col);
    template <bool Ahead> void scan_near_edges(datapath::TriangleSetup const& setup);
    template <bool Ahead> void send_near_edge_line(datapath::NearEdgeLine const& line);
    template <class Lines, bool Ahead> void scan_covered(datapath::TriangleSetup const& setup);
    template <class Lines, bool Ahead> void send_covered(datapath::ScanLine const& line);
    template <class Lines, bool Ahead> Scan scan_along() const;
    template <class Lines, bool Ahead> void scan_groups(datapath::TriangleSetup const& setup);
    template <class Lines, bool Ahead> void send_groups(datapath::GroupedLine const& line);
    void send_group_tokens(datapath::GroupedLine const& line);
    void send_stretch(datapath::ScanLine const& line, datapath::Stretch const& stretch);
    void begin_burst(datapath::TriangleSetup const& setup);
    void hand_over();
    void end_burst();
    void end_sample();
    void touch(std::size_t fragments);
    void touch(PixelGroup const& group);
    void send_region();
    void send_corner(FragmentIndex const& corner);

    void draw_overlapped(std::uint32_t triangles);
    void begin_triangle(datapath::TriangleSetup const& setup);
    void read_ahead();
    void first_iteration(timing::Ports ports);
    void fetch_vertex();
    template <bool Ahead> void iterate(timing::Ports ports, std::uint32_t count);
    template <bool Ahead>
    void iterate_with_tail(timing::Ports ports, std::uint32_t count, timing::Ports tail_ports, std::uint32_t tail_gap);
    template <bool Ahead>
    void iterate_flanked(timing::Ports ports, std::uint32_t count, timing::Ports tail_ports, std::uint32_t tail_gap);

    datapath::TriangleSetup set_up(TriangleCode const& triangle) const;
    EdgeToken token_at(int row, int col, EdgeTokenKind kind) const;

    CoreContext const& core_;
    ProcessClock clock_;
    bool sends_near_edges_;                   ///< thesis 5.1's edge tokens, not A.1's
    std::array<std::int64_t, 3> thresholds_;  ///< in codes of edge values
    Scan scan_;
    unsigned scan_loop_ = 0;
    // The clocked FIFOs behind the ports, for the scan's bursts.
    ClockedFifo<VertexCode>* vertex_ = nullptr;
    ClockedFifo<std::int64_t>* area_ = nullptr;
    ClockedFifo<Command>* command_ = nullptr;
    ClockedFifo<std::int64_t>* fragment_depth_ = nullptr;  ///< null: in groups, as the next two
    ClockedFifo<FragmentIndex>* fragment_index_ = nullptr;
    ClockedFifo<EdgeToken>* edge_token_ = nullptr;  ///< null also where no edges are looked for
    ClockedFifo<DepthGroup>* depth_groups_ = nullptr;
    ClockedFifo<PixelGroup>* index_groups_ = nullptr;
    ClockedFifo<PixelGroup>* edge_groups_ = nullptr;
    timing::Ports fragment_ports_;  ///< of an iteration that finds a covered pixel
    timing::Ports pixel_ports_;     ///< the same without an edge
    timing::Ports edge_port_;       ///< of an iteration that sends an edge

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
    std::optional<datapath::TouchedBox> touched_;  ///< sweep_region touched: by the sample at hand

    /// Triangles on their way to the scan, with setup_overlap.
    struct Fetching {
        std::uint32_t unread = 0;       ///< triangles of the sample whose vertices are still to be read
        unsigned first_iterations = 0;  ///< left of a triangle's first three
        bool reads = false;             ///< they read a vertex each
        TriangleCode triangle;          ///< vertices read so far
        std::deque<datapath::TriangleSetup> setups;
    };
    Fetching ahead_;

    int row_offset_ = 0;  ///< of the window, kept within 16 bits
    int col_offset_ = 0;
    bool previous_inside_ = false;  ///< thesis: prev_in_triangle
    int previous_row_ = 0;
    int previous_col_ = 0;
};

}  // namespace faster
