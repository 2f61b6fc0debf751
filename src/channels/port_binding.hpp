#pragma once
#include <systemc>

#include "channels/clocked_fifo.hpp"

namespace dataflow {

/// Ports that some flows leave unbound.
template <class Token>
using OptionalFifoIn = sc_core::sc_port<sc_core::sc_fifo_in_if<Token>, 1, sc_core::SC_ZERO_OR_MORE_BOUND>;
template <class Token>
using OptionalFifoOut = sc_core::sc_port<sc_core::sc_fifo_out_if<Token>, 1, sc_core::SC_ZERO_OR_MORE_BOUND>;

/// The clocked FIFO a port is bound to; for connecting clocks and for bursts. Once elaboration has ended.
/// Errors: std::bad_cast if the port is bound to any other kind of channel.
template <class Token> ClockedFifo<Token>& channel_of(sc_core::sc_fifo_in<Token>& port) {
    return dynamic_cast<ClockedFifo<Token>&>(*port.get_interface());
}
template <class Token> ClockedFifo<Token>& channel_of(sc_core::sc_fifo_out<Token>& port) {
    return dynamic_cast<ClockedFifo<Token>&>(*port.get_interface());
}

/// Null if the port is unbound.
template <class Token> ClockedFifo<Token>* channel_of(OptionalFifoIn<Token>& port) {
    return port.size() == 0 ? nullptr : &dynamic_cast<ClockedFifo<Token>&>(*port.get_interface());
}
template <class Token> ClockedFifo<Token>* channel_of(OptionalFifoOut<Token>& port) {
    return port.size() == 0 ? nullptr : &dynamic_cast<ClockedFifo<Token>&>(*port.get_interface());
}

}  // namespace dataflow
