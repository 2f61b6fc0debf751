#include "kernel/recording/bram_ports.hpp"

#include <fmt/format.h>

#include "faster/block_ram.hpp"
#include "kernel/machine/bank_partition.hpp"

namespace faster::recording {

std::vector<std::string> bram_port_names(BramId id, AcceleratorConfig const& config) {
    BramConfig const& bram = config.bram(id);
    std::uint64_t const banks = BankPartition(bram.partition, config.window).banks();
    std::uint64_t const buffers = memory_shape(id, config).buffers;
    std::vector<std::string> names;
    for (std::uint64_t buffer = 0; buffer < buffers; ++buffer)
        for (std::uint64_t bank = 0; bank < banks; ++bank)
            for (std::uint64_t port = 0; port < bram.ports; ++port)
                names.push_back((buffers == 1 ? "" : fmt::format("buffer{}_", buffer)) +
                                (banks == 1 ? "" : fmt::format("bank{}_", bank)) + fmt::format("port{}", port));
    return names;
}

}  // namespace faster::recording
