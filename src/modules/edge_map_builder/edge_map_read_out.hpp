#pragma once
#include "channels/clocked_fifo.hpp"
#include "faster/config/edge_map_design.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

namespace faster {

/// Reads the edge map of a sample out: part of the edge map builder's process, or of one of its own (EdgeMapOutput).
///   time  loop `output`, one token per iteration; without any, a cycle
/// Source: thesis A.2; docs/timing-model.md#sources-of-time.
class EdgeMapReadOut {
  public:
    /// Adds what an iteration does to the maps, bits of map_touch each, that works on `lanes` pixels of a row.
    static void touch(LoopDescription& loop, PerMap const& touches, int lanes = 1);
    /// Adds the writing end of edge_map, and the loop.
    static void describe_output(ModuleDescription& module, AcceleratorConfig const& config, Condition condition = {});
    static LoopDescription& describe_loop(ModuleDescription& module, AcceleratorConfig const& config);

    EdgeMapReadOut(CoreContext const& core, ProcessClock& clock) : core_(core), clock_(clock) {}
    /// When the process's clock is connected.
    void connect(ClockedFifo<std::uint8_t>& out);
    void send(datapath::EdgeMapPolicy const& maps, LaneRows const& rows);

  private:
    CoreContext const& core_;
    ProcessClock& clock_;
    ClockedFifo<std::uint8_t>* out_ = nullptr;
    unsigned loop_ = 0;
};

}  // namespace faster
