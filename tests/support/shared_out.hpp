#pragma once
#include <cstddef>

#include "channels/simulate.hpp"
#include "faster/dataflow_names.hpp"

namespace faster::testing {

/// Options of a run of so many samples. How a run is shared between host cores makes no difference: between processes
/// in a fifth of all, as they cost more than such a run takes.
inline SimulationOptions shared_out(std::size_t samples) {
    SimulationOptions options;
    options.jobs = 1 + samples % 3;
    options.figures_alone = samples % 5 == 4;
    return options;
}

}  // namespace faster::testing
