#include "dataflow/tools/recording/memory_ports.hpp"

#include <algorithm>

namespace dataflow::recording {

bool MemoryPorts::has_read(std::size_t memory, std::uint64_t address) const {
    return std::any_of(accesses_.begin(), accesses_.end(), [=](PortAccess const& access) {
        return !access.writes && access.memory == memory && access.address == address;
    });
}

void MemoryPorts::add(std::size_t memory, bool writes, std::uint64_t address, std::size_t buffer) {
    MachineMemory const& shape = machine_.memories[memory];
    auto const row = static_cast<std::int64_t>(address / shape.cols);
    auto const col = static_cast<std::int64_t>(address % shape.cols);
    std::uint64_t const bank = buffer * shape.partition.banks() + shape.partition.bank_of(row, col);
    std::uint64_t const number = accesses_so_far(memory, bank);
    accesses_.push_back(
        {memory, bank * shape.ports + number % shape.ports, cycle_ + number / shape.ports, writes, address, buffer});
}

std::uint64_t MemoryPorts::accesses_so_far(std::size_t memory, std::uint64_t bank) const {
    auto const is_in_bank = [&](PortAccess const& access) {
        return access.memory == memory && access.port / machine_.memories[memory].ports == bank;
    };
    return static_cast<std::uint64_t>(std::count_if(accesses_.begin(), accesses_.end(), is_in_bank));
}

}  // namespace dataflow::recording
