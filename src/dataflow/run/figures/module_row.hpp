#pragma once
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow {

/// Cycles by the name of what they went into.
struct NamedCycles {
    std::string name;
    Cycles cycles = 0;
    friend bool operator==(NamedCycles const& a, NamedCycles const& b) {
        return a.name == b.name && a.cycles == b.cycles;
    }
};

/// One row of the table of modules in summary.json.
struct ModuleRow {
    std::uint64_t core = 0;
    std::string module;
    std::array<Cycles, cycle_class_count> cycles{};
    std::vector<NamedCycles> stalls;          ///< of the FIFOs that it reads and writes
    std::vector<NamedCycles> port_conflicts;  ///< of all block RAMs
    bool has_external_memory = false;

    bool has_class(std::size_t which) const { return is_class_of(which, has_external_memory); }
};

/// The column of a class: "busy_cycles".
inline std::string cycles_column(char const* cycle_class) { return std::string(cycle_class) + "_cycles"; }

}  // namespace dataflow
