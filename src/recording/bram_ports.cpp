#include "recording/bram_ports.hpp"

#include <fmt/format.h>

#include "config/bank_partition.hpp"

namespace faster::recording {

std::vector<std::string> bram_port_names(BramId id, AcceleratorConfig const& config) {
    BramConfig const& bram = config.bram(id);
    std::uint64_t const banks = BankPartition(bram.partition, config.window).banks();
    std::vector<std::string> names;
    for (std::uint64_t bank = 0; bank < banks; ++bank)
        for (std::uint64_t port = 0; port < bram.ports; ++port)
            names.push_back(banks == 1 ? fmt::format("port{}", port) : fmt::format("bank{}_port{}", bank, port));
    return names;
}

}  // namespace faster::recording
