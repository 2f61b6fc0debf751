#pragma once
#include "channels/clocked_fifo.hpp"
#include "datapath/edge_map/edge_map_policy.hpp"
#include "modules/core_context.hpp"

namespace faster {

/// Reads the edge map of a sample out: part of the edge map builder's process, or of one of its own (EdgeMapOutput).
///   time  loop `output`, one token per iteration; without any, a cycle
/// Source: thesis A.2; SPEC section 3.
class EdgeMapReadOut {
  public:
    EdgeMapReadOut(CoreContext const& core, ProcessClock& clock) : core_(core), clock_(clock) {}
    /// When elaboration has ended, behind the other loops of the process. `out`: connected.
    void add_loop(ClockedFifo<std::uint8_t>& out);
    void send(datapath::EdgeMapPolicy const& maps, LaneRows const& rows);

  private:
    CoreContext const& core_;
    ProcessClock& clock_;
    ClockedFifo<std::uint8_t>* out_ = nullptr;
    unsigned loop_ = 0;
};

}  // namespace faster
