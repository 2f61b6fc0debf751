#pragma once
#include <systemc>

#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/rasterizer/run_iterations.hpp"
#include "modules/rasterizer/scan_burst.hpp"
#include "modules/rasterizer/triangle_setup.hpp"
#include "modules/rasterizer/zigzag_scan.hpp"

namespace faster {

/// Scans a sample's triangles in zigzag and finds, while it does, which pixels they cover and where their edges are:
/// thesis 4.1.1 and A.1, and nothing else. RasterizerVariant has what keys add.
///   in    sample_raster_in, then three tokens of vertex_in per triangle
///   out   area_out            per triangle: twice its area, 0 if rejected
///         command_out         Triangle per drawn triangle, Fragment per covered pixel, End per sample
///         fragment_depth_out  z sum of each fragment
///         fragment_index_out  its pixel in the window
///         edge_token_out      object and edge pixels, End per sample
///   time  per triangle 3 vertex steps, `setup`, one step to announce it; loop `scan`, one pixel or edge flush per
///         iteration
class Rasterizer : public CoreModule {
  public:
    sc_core::sc_fifo_in<SampleHeader> sample_raster_in{"sample_raster_in"};
    sc_core::sc_fifo_in<VertexCode> vertex_in{"vertex_in"};
    sc_core::sc_fifo_out<std::int64_t> area_out{"area_out"};
    sc_core::sc_fifo_out<Command> command_out{"command_out"};
    sc_core::sc_fifo_out<std::int64_t> fragment_depth_out{"fragment_depth_out"};
    sc_core::sc_fifo_out<FragmentIndex> fragment_index_out{"fragment_index_out"};
    sc_core::sc_fifo_out<EdgeToken> edge_token_out{"edge_token_out"};

    static ModuleDescription describe();

    using CoreModule::CoreModule;

  private:
    void connect() override;
    void work(std::size_t i) override;
    TriangleCode receive_triangle();
    void draw(TriangleCode const& triangle);
    void scan(datapath::TriangleSetup const& setup);
    void scan_line(datapath::ScanLine const& line);
    void scan_run(datapath::ScanLine const& line);
    void end_sample();

    unsigned scan_loop_ = 0;
    ScanPorts ports_;
    ScanBurst burst_;
    WindowPlace window_;
    EdgeToken previous_;            ///< the pixel before the one at hand, as the edge that it may be
    bool previous_inside_ = false;  ///< thesis: prev_in_triangle
};

}  // namespace faster
