#pragma once
#include <string>
#include <vector>

#include "faster/accelerator_config.hpp"

namespace faster::recording {

/// How waveforms name the ports of a block RAM, bank by bank: "port0", "port1"; of several banks "bank0_port0", ...;
/// of two buffers "buffer0_port0", .., "buffer1_port0", ...
std::vector<std::string> bram_port_names(BramId bram, AcceleratorConfig const& config);

}  // namespace faster::recording
