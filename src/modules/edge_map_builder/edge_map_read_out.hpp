#pragma once
#include "channels/token_loop.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/edge_map_builder/algorithms/edge_map_policy.hpp"

namespace faster {

/// Reads the edge map of a sample out, or a region of it, several bits per token: part of the process of the
/// EdgeMapBuilderVariant, or of one of its own (EdgeMapOutput).
///   time  loop `output`, one token per iteration; without any, a cycle
/// Source: thesis A.2; docs/timing-model.md#sources-of-time.
class EdgeMapReadOut {
  public:
    /// The EdgeMapBuilder's writing end of edge_map and its loop, as the configuration changes them.
    static FifoEnd described_end(AcceleratorConfig const& config);
    static LoopDescription described_loop(AcceleratorConfig const& config);

    explicit EdgeMapReadOut(ProcessClock& clock) : clock_(clock) {}
    /// When the process's clock is connected.
    void connect(ClockedFifo<std::uint8_t>& out);
    void send(datapath::EdgeMapPolicy const& maps, LaneRows const& rows);

  private:
    ProcessClock& clock_;
    TokenLoop<Reads<>, Writes<std::uint8_t>> output_;
};

}  // namespace faster
