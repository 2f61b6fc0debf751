#pragma once
#include "chance/chance_design.hpp"
#include "chance/figures.hpp"

namespace faster::chance {

/// What a design does, cycle by cycle, by a simulation that shares nothing with the kernel but the design as data.
Figures simulated(Design const& design);

}  // namespace faster::chance
