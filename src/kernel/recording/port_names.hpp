#pragma once
#include <string>
#include <vector>

#include "kernel/machine/machine.hpp"

namespace faster::recording {

/// How waveforms name the ports of a memory, bank by bank: "port0", "port1"; of several banks "bank0_port0", ...; of
/// two buffers "buffer0_port0", .., "buffer1_port0", ...
std::vector<std::string> port_names(MachineMemory const& memory);

/// Bits of an address of the memory.
unsigned address_bits(MachineMemory const& memory);

}  // namespace faster::recording
