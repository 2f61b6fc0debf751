#pragma once
#include <cstddef>
#include <cstdint>

#include "dataflow/base/cycles.hpp"
#include "dataflow/tools/recording/event.hpp"
#include "dataflow/tools/recording/memory_ports.hpp"

namespace dataflow::recording {

/// A process reads a token.
struct TokenRead {
    std::size_t process = 0;  ///< numbers of parts of the machine
    std::size_t fifo = 0;
    TokenValues const& fields;
    Cycles cycle = 0;
};

/// A process begins an iteration of a loop.
struct LoopIteration {
    std::size_t process = 0;  ///< numbers of parts of the machine
    std::size_t loop = 0;
    std::int64_t number = 0;  ///< from 0 on, since the loop was entered
    Cycles cycle = 0;
};

/// Which words of its memories a core accesses. A recording knows tokens and iterations, but no addresses: a design
/// that wants its memories in a waveform derives this class and works the addresses out. It is told all that happens in
/// one core, in the order of cycles.
class MemoryActivity {
  public:
    virtual ~MemoryActivity() = default;
    virtual void token_read(TokenRead const& /*read*/) {}
    /// Puts all accesses of the iteration into `ports`, in the order in which its schedule has them.
    virtual void iterated(LoopIteration const& iteration, MemoryPorts& ports) = 0;
};

}  // namespace dataflow::recording
