#pragma once
#include <deque>
#include <optional>
#include <systemc>

#include "channels/clocked_fifo.hpp"
#include "channels/pixels_fifo.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/rasterizer/grouped_line.hpp"
#include "modules/rasterizer/near_edge_scan.hpp"
#include "modules/rasterizer/run_iterations.hpp"
#include "modules/rasterizer/scan_burst.hpp"
#include "modules/rasterizer/touched_box.hpp"
#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster {

/// What keys make of the Rasterizer: other scans and edge tokens, several lanes, triangles prepared beside the scan,
/// the touched region, no edges at all. Ports and time are the Rasterizer's, but for:
///   out   edge_token_out  unbound in flow fpga_grip. Edge map algorithm threshold: pixels near an edge
///         region_out      sweep_region touched: first and last pixel of the box that the sample can have changed; so
///                         do fragment_index_out and edge_token_out, after End
///         With several lanes fragment_depth_out, fragment_index_out and edge_token_out carry groups: the covered
///         pixels of `lanes` adjacent ones, as one fragment
///   time  loop `scan`: a pixel, group or edge flush per iteration. With setup_overlap one loop `scan` per sample: its
///         iterations also read vertices and announce triangles
class RasterizerVariant : public CoreModule {
  public:
    sc_core::sc_fifo_in<SampleHeader> sample_raster_in{"sample_raster_in"};
    sc_core::sc_fifo_in<VertexCode> vertex_in{"vertex_in"};
    sc_core::sc_fifo_out<std::int64_t> area_out{"area_out"};
    sc_core::sc_fifo_out<Command> command_out{"command_out"};
    PixelsOut<std::int64_t, DepthGroup> fragment_depth_out{"fragment_depth_out"};
    PixelsOut<FragmentIndex, PixelGroup> fragment_index_out{"fragment_index_out"};
    PixelsOut<EdgeToken, PixelGroup> edge_token_out{"edge_token_out"};  ///< unbound in flow fpga_grip
    OptionalFifoOut<FragmentIndex> region_out{"region_out"};            ///< unbound unless touched

    /// Whether a configuration takes more than the Rasterizer.
    static bool is_needed(AcceleratorConfig const& config);
    static ModuleDescription describe(AcceleratorConfig const& config);

    RasterizerVariant(sc_core::sc_module_name const& name, CoreContext const& core);

  private:
    void connect() override;
    void work(std::size_t i) override;
    void start_sample();
    void draw_one_by_one(std::uint32_t triangles);
    TriangleCode receive_triangle();
    void announce(datapath::TriangleSetup const& setup);

    /// Draws a triangle's box in a loop; `Lines` is how it walks, `Ahead` whether its iterations do more than that.
    using Scan = void (RasterizerVariant::*)(datapath::TriangleSetup const& setup);
    template <bool Ahead> Scan configured_scan() const;
    template <class Lines, bool Ahead> void scan(datapath::TriangleSetup const& setup);
    template <class Lines, bool Ahead> void send_line(datapath::ScanLine const& line);
    template <class Lines, bool Ahead> void send_run(datapath::ScanLine const& line);
    template <bool Ahead> void send_edge(EdgeToken const& token);
    template <bool Ahead> void scan_near_edges(datapath::TriangleSetup const& setup);
    template <bool Ahead> void send_near_edge_line(datapath::NearEdgeLine const& line);
    template <class Lines, bool Ahead> void scan_covered(datapath::TriangleSetup const& setup);
    template <class Lines, bool Ahead> void send_covered(datapath::ScanLine const& line);
    template <class Lines, bool Ahead> Scan scan_along() const;
    template <class Lines, bool Ahead> void scan_groups(datapath::TriangleSetup const& setup);
    template <class Lines, bool Ahead> void send_groups(datapath::GroupedLine const& line);
    void send_group_tokens(datapath::GroupedLine const& line);
    void hand_over();
    void hand_over_in_lockstep();
    void end_burst();
    void end_sample();
    void touch_written();
    void send_region();
    void send_corner(FragmentIndex const& corner);

    void draw_overlapped(std::uint32_t triangles);
    void begin_triangle(datapath::TriangleSetup const& setup);
    void read_ahead();
    void first_iteration(timing::Ports ports);
    void fetch_vertex();
    template <bool Ahead> void iterate(timing::Ports ports, std::uint32_t count);

    datapath::TriangleSetup set_up(TriangleCode const& triangle) const;

    bool sends_near_edges_;                   ///< thesis 5.1's edge tokens, not A.1's
    std::array<std::int64_t, 3> thresholds_;  ///< in codes of edge values
    Scan scan_;
    unsigned scan_loop_ = 0;
    // The clocked FIFOs behind the ports, for the scan's bursts.
    ClockedFifo<VertexCode>* vertex_ = nullptr;
    ClockedFifo<std::int64_t>* area_ = nullptr;
    ClockedFifo<Command>* command_ = nullptr;
    ClockedFifo<FragmentIndex>* fragment_index_ = nullptr;  ///< null with several lanes: see index_groups_
    ClockedFifo<EdgeToken>* edge_token_ = nullptr;          ///< null also where no edges are looked for
    ClockedFifo<DepthGroup>* depth_groups_ = nullptr;
    ClockedFifo<PixelGroup>* index_groups_ = nullptr;
    ClockedFifo<PixelGroup>* edge_groups_ = nullptr;
    ScanPorts ports_;
    timing::Ports pixel_ports_;  ///< of an iteration that finds a covered pixel and tells nothing of edges

    ScanBurst burst_;                              ///< of pixels one by one
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

    WindowPlace window_;
    EdgeToken previous_;            ///< the pixel before the one at hand, as the edge that it may be
    bool previous_inside_ = false;  ///< thesis: prev_in_triangle
};

}  // namespace faster
