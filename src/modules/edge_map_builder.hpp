#pragma once
#include <memory>
#include <systemc>

#include "channels/clocked_fifo.hpp"
#include "channels/pixels_fifo.hpp"
#include "common/tokens.hpp"
#include "datapath/edge_map/edge_map_policy.hpp"
#include "modules/core_context.hpp"

namespace faster {

/// Merges the edges of single triangles into the contour of the object, as accelerator.edge_map.algorithm says.
///   in    edge_token_in  object and edge pixels in any order, End per sample; sweep_region touched: then the corners
///   of
///                        the touched region
///   out   edge_map_out   W x W bits per sample, or those of the region, row-major, `sweep_lanes` bits of a row per
///   token time  loop `clear`, loop `token` (some tokens take two iterations), loop `output`
/// Source: thesis 4.1.2, chapter 5 and A.2; SPEC sections 2 and 3.
class EdgeMapBuilder : public sc_core::sc_module {
  public:
    PixelsIn<EdgeToken, PixelGroup> edge_token_in{"edge_token_in"};
    sc_core::sc_fifo_out<std::uint8_t> edge_map_out{"edge_map_out"};

    SC_HAS_PROCESS(EdgeMapBuilder);
    EdgeMapBuilder(sc_core::sc_module_name const& name, CoreContext const& core);
    ProcessClock const& clock() const { return clock_; }

  private:
    void end_of_elaboration() override;
    void run();
    void clear();
    void build();
    bool take_tokens(EdgeToken& current);
    void take_some(EdgeToken& current, EdgeToken const* next, unsigned count);
    void take_last(EdgeToken const& current);
    void build_of_groups();
    bool take_groups(PixelGroup& current);
    void take_group(PixelGroup const& group);
    PixelBox turn_to_output();
    FragmentIndex read_corner();
    void output(LaneRows const& rows);

    CoreContext const& core_;
    ProcessClock clock_;
    std::unique_ptr<datapath::EdgeMapPolicy> maps_;
    ClockedFifo<EdgeToken>* edge_token_ = nullptr;  ///< null: tokens are groups
    ClockedFifo<PixelGroup>* edge_groups_ = nullptr;
    unsigned clear_loop_ = 0;
    unsigned token_loop_ = 0;
    unsigned output_loop_ = 0;
};

}  // namespace faster
