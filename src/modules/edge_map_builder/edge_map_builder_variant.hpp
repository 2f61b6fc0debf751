#pragma once
#include <systemc>

#include "channels/pixels_fifo.hpp"
#include "channels/port_binding.hpp"
#include "channels/token_loop.hpp"
#include "faster/data/buffer_tokens.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/edge_map_builder/edge_map_buffers.hpp"
#include "modules/edge_map_builder/edge_map_read_out.hpp"
#include "modules/edge_map_builder/watched_maps.hpp"

namespace faster {

/// What keys make of the EdgeMapBuilder: other algorithms, tokens of several pixels, other ways to clear, the touched
/// region. Ports and time are the EdgeMapBuilder's, but for:
///   in    edge_token_in  groups of covered pixels with several `rasterizer.lanes`. sweep_region touched: after End the
///                        corners of the touched region
///   out   edge_map_out   the bits of the region, `sweep_lanes` bits of a row per token
/// With two buffers, EdgeMapOutput reads the maps out:
///   in    map_free_in    the buffer of the next sample
///   out   map_full_out   the finished one and its region, instead of edge_map_out
///   time  a step each instead of loop `output`
class EdgeMapBuilderVariant : public CoreModule {
  public:
    PixelsIn<EdgeToken, PixelGroup> edge_token_in{"edge_token_in"};
    OptionalFifoIn<BufferNumber> map_free_in{"map_free_in"};     ///< bound with two buffers
    OptionalFifoOut<FullMaps> map_full_out{"map_full_out"};      ///< bound with two buffers
    OptionalFifoOut<std::uint8_t> edge_map_out{"edge_map_out"};  ///< bound with one buffer

    /// Whether a core takes more than the EdgeMapBuilder.
    static bool is_needed(AcceleratorConfig const& config);
    static ModuleDescription describe(AcceleratorConfig const& config);

    EdgeMapBuilderVariant(sc_core::sc_module_name const& name, CoreContext const& core, EdgeMapBuffers& buffers);

  private:
    void connect() override;
    void start() override;
    void work(std::size_t i) override;
    void clear();
    void build();
    void build_of_groups();
    PixelBox turn_to_output();
    Corners read_region();
    FragmentIndex read_corner();
    void hand_over();

    EdgeMapBuffers& buffers_;
    std::size_t buffer_ = 0;
    datapath::EdgeMapPolicy* maps_ = nullptr;       ///< of the sample at hand
    EdgeMapReadOut read_out_;                       ///< one buffer
    ClockedFifo<EdgeToken>* edge_token_ = nullptr;  ///< null: tokens are groups
    ClockedFifo<PixelGroup>* edge_groups_ = nullptr;
    ClockedFifo<BufferNumber>* map_free_ = nullptr;  ///< two buffers
    ClockedFifo<FullMaps>* map_full_ = nullptr;      ///< two buffers
    TokenLoop<Reads<EdgeToken>> token_;
    TokenLoop<Reads<PixelGroup>> group_;  ///< the same loop
    WatchedMaps watched_;
};

}  // namespace faster
