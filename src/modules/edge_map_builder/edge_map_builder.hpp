#pragma once
#include <systemc>

#include "channels/token_loop.hpp"
#include "faster/data/tokens.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_module.hpp"
#include "modules/edge_map_builder/algorithms/dual_map.hpp"
#include "modules/edge_map_builder/watched_maps.hpp"

namespace faster {

/// Merges the edges of single triangles into the contour of the object: thesis 5.4 and A.2. Of the
/// keys it knows `edge_map.flush_last` alone; EdgeMapBuilderVariant has what the others add. What a token does to the
/// two maps is in algorithms/dual_map.hpp.
///   in    edge_token_in  object and edge pixels in any order, End per sample
///   out   edge_map_out   W x W bits per sample, row-major
///   time  loop `clear`, loop `token` (object tokens take two iterations), loop `output`
class EdgeMapBuilder : public CoreModule {
  public:
    sc_core::sc_fifo_in<EdgeToken> edge_token_in{"edge_token_in"};
    sc_core::sc_fifo_out<std::uint8_t> edge_map_out{"edge_map_out"};

    /// Of a window of so many pixels.
    static ModuleDescription describe(int window);

    EdgeMapBuilder(sc_core::sc_module_name const& name, CoreContext const& core);

  private:
    void connect() override;
    void work(std::size_t i) override;
    void clear();
    void build();
    void send();

    datapath::DualMap maps_;
    WatchedMaps watched_;
    TokenLoop<Reads<EdgeToken>> token_;
    TokenLoop<Reads<>, Writes<std::uint8_t>> output_;
};

}  // namespace faster
