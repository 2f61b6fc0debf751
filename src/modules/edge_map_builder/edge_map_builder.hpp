#pragma once
#include <systemc>

#include "channels/clocked_fifo.hpp"
#include "channels/pixels_fifo.hpp"
#include "channels/port_binding.hpp"
#include "faster/data/buffer_tokens.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/edge_map_builder/edge_map_buffers.hpp"
#include "modules/edge_map_builder/edge_map_read_out.hpp"

namespace faster {

/// Merges the edges of single triangles into the contour of the object, as accelerator.edge_map.algorithm says.
///   in    edge_token_in  object and edge pixels in any order, End per sample; sweep_region touched: then the corners
///                        of the touched region
///   out   edge_map_out   W x W bits per sample, or those of the region, row-major, `sweep_lanes` bits of a row per
///   token time  loop `clear`, loop `token` (some tokens take two iterations), loop `output`
/// With two buffers, EdgeMapOutput reads the maps out:
///   in    map_free_in    the buffer of the next sample
///   out   map_full_out   the finished one and its region, instead of edge_map_out
///   time  a step each instead of loop `output`
/// Source: thesis 4.1.2, chapter 5 and A.2; docs/function.md#edgemapbuilder, docs/timing-model.md#sources-of-time.
class EdgeMapBuilder : public sc_core::sc_module {
  public:
    PixelsIn<EdgeToken, PixelGroup> edge_token_in{"edge_token_in"};
    OptionalFifoIn<BufferNumber> map_free_in{"map_free_in"};     ///< bound with two buffers
    OptionalFifoOut<FullMaps> map_full_out{"map_full_out"};      ///< bound with two buffers
    OptionalFifoOut<std::uint8_t> edge_map_out{"edge_map_out"};  ///< bound with one buffer

    static ModuleDescription describe(AcceleratorConfig const& config);

    SC_HAS_PROCESS(EdgeMapBuilder);
    EdgeMapBuilder(sc_core::sc_module_name const& name, CoreContext const& core, EdgeMapBuffers& buffers);
    ProcessClock const& clock() const { return clock_; }

  private:
    void end_of_elaboration() override;
    void run();
    void clear();
    void build();
    bool take_tokens(EdgeToken& current);
    void take_some(EdgeToken& current, EdgeToken const* next, unsigned count);
    bool is_watched() const { return watch_.edge_map != nullptr || watch_.object_map != nullptr; }
    void tell_one(bool second);
    std::uint32_t take_watched(EdgeToken const& current, EdgeToken const* next, unsigned count);
    void take_last(EdgeToken const& current);
    void build_of_groups();
    bool take_groups(PixelGroup& current);
    void take_group(PixelGroup const& group);
    PixelBox turn_to_output();
    Corners read_region();
    FragmentIndex read_corner();
    void hand_over();

    CoreContext const& core_;
    ProcessClock clock_;
    EdgeMapBuffers& buffers_;
    std::size_t buffer_ = 0;
    datapath::EdgeMapPolicy* maps_ = nullptr;       ///< of the sample at hand
    EdgeMapReadOut read_out_;                       ///< one buffer
    ClockedFifo<EdgeToken>* edge_token_ = nullptr;  ///< null: tokens are groups
    ClockedFifo<PixelGroup>* edge_groups_ = nullptr;
    ClockedFifo<BufferNumber>* map_free_ = nullptr;  ///< two buffers
    ClockedFifo<FullMaps>* map_full_ = nullptr;      ///< two buffers
    unsigned clear_loop_ = 0;
    unsigned token_loop_ = 0;
    datapath::MapWatch watch_;       ///< told what the token loop does; mostly nobody wants to know
    bool waits_for_writes_ = false;  ///< iterations of the token loop for each other's: they are told one by one
};

}  // namespace faster
