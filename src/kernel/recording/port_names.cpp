#include "kernel/recording/port_names.hpp"

#include <fmt/format.h>

#include "kernel/recording/waveform_file.hpp"

namespace faster::recording {

std::vector<std::string> port_names(MachineMemory const& memory) {
    std::uint64_t const banks = memory.partition.banks();
    std::uint64_t const buffers = memory.shape.buffers;
    std::vector<std::string> names;
    for (std::uint64_t buffer = 0; buffer < buffers; ++buffer)
        for (std::uint64_t bank = 0; bank < banks; ++bank)
            for (std::uint64_t port = 0; port < memory.ports; ++port)
                names.push_back((buffers == 1 ? "" : fmt::format("buffer{}_", buffer)) +
                                (banks == 1 ? "" : fmt::format("bank{}_", bank)) + fmt::format("port{}", port));
    return names;
}

unsigned address_bits(MachineMemory const& memory) { return signal_bits(memory.words - 1); }

}  // namespace faster::recording
