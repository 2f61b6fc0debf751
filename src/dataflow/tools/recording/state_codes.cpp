#include "dataflow/tools/recording/state_codes.hpp"

#include <fmt/format.h>
#include <iterator>
#include <sstream>

namespace dataflow::recording {

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

std::vector<std::string> state_names(Machine const& machine) {
    std::vector<std::string> names(machine.loops.size() + 1);
    names[between_loops] = "-";
    for (std::size_t const loop : loops_of(machine))
        names[static_cast<std::size_t>(in_loop(loop))] = machine.loops[loop].name;
    return names;
}

std::vector<std::string> stall_names(Machine const& machine) {
    std::size_t const fifos = machine.fifos.size();
    std::vector<std::string> names(static_cast<std::size_t>(stall_on(fifos, false)) + 1);
    names[no_stall] = "-";
    for (std::size_t const fifo : fifos_of(machine))
        for (bool const is_full : {false, true})
            names[static_cast<std::size_t>(stall_on(fifo, is_full))] =
                machine.fifos[fifo].name + (is_full ? " full" : " empty");
    if (machine.external_memory)
        names.back() = "memory";
    return names;
}

std::vector<std::string> value_names(TokenField const& field) {
    std::istringstream words(field.values == nullptr ? "" : field.values);
    return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace dataflow::recording
