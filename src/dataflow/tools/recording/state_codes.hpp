#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/base/token_field.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/tools/recording/waveform_file.hpp"

namespace dataflow::recording {

/// How waveforms name the ports of a memory, bank by bank: "port0", "port1"; of several banks "bank0_port0", ...; of
/// two buffers "buffer0_port0", .., "buffer1_port0", ...
std::vector<std::string> port_names(MachineMemory const& memory);

/// Bits of an address of the memory.
unsigned address_bits(MachineMemory const& memory);

/// The values of a module's `stall`: none, or a FIFO and whether it is empty or full, or memory.
constexpr std::int64_t no_stall = 0;
constexpr std::int64_t stall_on(std::size_t fifo, bool is_full) {
    return static_cast<std::int64_t>(1 + 2 * fifo + (is_full ? 1 : 0));
}
/// The value of `stall` on a FIFO or on the external memory, which stands behind all FIFOs.
inline std::int64_t stall_on(Machine const& machine, std::size_t item, std::size_t process) {
    return stall_on(item, item < machine.fifos.size() && machine.fifos[item].writer == process);
}
/// The values of a module's `state`: between its loops, or in a loop.
constexpr std::int64_t between_loops = 0;
constexpr std::int64_t in_loop(std::size_t loop) { return static_cast<std::int64_t>(1 + loop); }

/// What they mean, value by value; empty: parts that the machine has not.
std::vector<std::string> state_names(Machine const& machine);
std::vector<std::string> stall_names(Machine const& machine);
/// What the values of a field of a token mean; empty if it is a number.
std::vector<std::string> value_names(TokenField const& field);

/// Bits of these signals: a byte, unless the machine has more loops or FIFOs than that tells apart.
inline unsigned state_bits(Machine const& machine) { return std::max(8U, signal_bits(machine.loops.size())); }
inline unsigned stall_bits(Machine const& machine) { return std::max(8U, signal_bits(2 * machine.fifos.size() + 1)); }

}  // namespace dataflow::recording
