#pragma once
#include <cstdint>
#include <string>

#include "dataflow/run/config/load_config.hpp"
#include "faster/dataflow_names.hpp"
#include "poses/commands/estimate_scene.hpp"

namespace faster {

/// `faster-sim estimate --all`.
struct EstimateAllRequest {
    BopRequest bop;
    std::string out;        ///< folder
    std::int64_t jobs = 0;  ///< processes at once; 0: the host's cores
    bool force = false;     ///< however long it takes
};

/// Looks for every target of a dataset that has a box, and writes results.csv, as BOP has it, into the folder. Goes on
/// where it was if it has been interrupted. Throws InputError on bad input. Exit code 1 if an estimate crashed.
int estimate_all(EstimateAllRequest const& request, LoadedConfig const& loaded);

}  // namespace faster
