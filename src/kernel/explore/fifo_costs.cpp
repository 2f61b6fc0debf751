#include "kernel/explore/fifo_costs.hpp"

#include "kernel/sizing/fifo_choice.hpp"

namespace faster::explore {

sizing::Primitives primitives_of_fifo(Machine const& machine, std::size_t fifo) {
    sizing::FifoFreedom const freedom = sizing::freedom_of(machine.fifos[fifo]);
    return sizing::primitives_of(sizing::choice_of(machine)[fifo], freedom, {});
}

std::vector<report::FifoCost> fifo_costs(Machine const& machine) {
    std::vector<report::FifoCost> costs;
    for (std::size_t const i : fifos_of(machine)) {
        sizing::Primitives const takes = primitives_of_fifo(machine, i);
        costs.push_back(
            {machine.fifos[i].name, machine.fifos[i].bits, takes.luts, static_cast<double>(takes.ramb18) / 2});
    }
    return costs;
}

}  // namespace faster::explore
