#pragma once
#include <systemc>

#include "channels/clocked_fifo.hpp"

namespace faster {

/// The clocked FIFO a port is bound to; for connecting clocks and for bursts. Once elaboration has ended.
/// Errors: std::bad_cast if the port is bound to any other kind of channel.
template <class Token> ClockedFifo<Token>& channel_of(sc_core::sc_fifo_in<Token>& port) {
    return dynamic_cast<ClockedFifo<Token>&>(*port.get_interface());
}
template <class Token> ClockedFifo<Token>& channel_of(sc_core::sc_fifo_out<Token>& port) {
    return dynamic_cast<ClockedFifo<Token>&>(*port.get_interface());
}

}  // namespace faster
