#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/machine/dependence.hpp"

namespace dataflow {

/// What has been seen of a dependence of a loop of a core. See WriteDistances.
struct DependenceStatistics {
    std::size_t loop = 0;               ///< its number in the machine
    std::size_t number = 0;             ///< of the dependence among those of the loop
    std::uint64_t smallest = 0;         ///< distance in iterations; 0: there was none
    std::vector<std::uint64_t> counts;  ///< by distance, those below the span
};

/// One row of the table of hazards.
struct DependenceRow {
    std::uint64_t core = 0;
    std::string module;
    std::string loop;
    std::string bram;
    Cycles ii = 1;
    MachineDependence dependence;
    unsigned address_bits = 0;
    unsigned word_bits = 0;
    std::uint64_t smallest = 0;
    std::vector<std::uint64_t> counts;
    Cycles interlock_cycles = 0;  ///< that iterations of the loop waited, for all its memories

    std::string name() const { return module + "." + loop; }
    /// Iterations, once for each word, that come too early.
    std::uint64_t hazards() const;
    /// What forwarding or waiting takes in a core: every word read is compared with every word written of the
    /// iterations that it may be too early for; of those, address and a valid bit are kept, and the word to forward.
    std::uint64_t comparators() const;
    std::uint64_t register_bits() const;
};

}  // namespace dataflow
