#pragma once
#include <vector>

#include "kernel/machine/machine.hpp"
#include "kernel/report/html/html_report.hpp"
#include "kernel/sizing/fifo_cost.hpp"

namespace faster::explore {

/// What a FIFO of a machine is kept in.
sizing::Primitives primitives_of_fifo(Machine const& machine, std::size_t fifo);

/// Of all FIFOs of a core, for the report.
std::vector<report::FifoCost> fifo_costs(Machine const& machine);

}  // namespace faster::explore
