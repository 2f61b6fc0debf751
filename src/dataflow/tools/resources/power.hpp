#pragma once
#include <string>
#include <vector>

#include "dataflow/run/figures/run_statistics.hpp"
#include "dataflow/tools/resources/path_table.hpp"

namespace dataflow {

/// Energies of primitives of an UltraScale+ device at 0.85 V, with their nets: engineering estimates, which no run is
/// fitted to. docs/hardware.md says how they come about.
struct PowerCoefficients {
    Estimate lut_pj{0.02, 0.035, 0.06};      ///< a cycle in which its module is busy
    Estimate ff_pj{0.006, 0.010, 0.018};     ///< a cycle, its share of the clock tree included
    Estimate dsp_pj{3, 6, 10};               ///< a cycle in which its module is busy
    Estimate fifo_bit_pj{0.05, 0.10, 0.20};  ///< a bit written and read
    Estimate bram_access_pj{5, 10, 20};      ///< a word of at most 36 bits
    Estimate static_w{0.6, 0.75, 1.0};       ///< of the programmable logic
    Estimate ps_w{1.5, 2.0, 2.8};            ///< of the processing system, with its memory controller
};

struct PowerRow {
    std::string name;
    Estimate milliwatts;
};

/// What a run burns on average, and its energy. Everything is of all cores.
struct RunPower {
    std::vector<PowerRow> modules;  ///< logic and clock of each
    PowerRow fifos;                 ///< moving tokens
    PowerRow memories;              ///< accesses of block RAMs
    PowerRow beside;                ///< what is beside the cores, as busy as their modules are on average
    Estimate dynamic_w;             ///< of all these
    Estimate static_w;
    Estimate ps_w;
    Estimate total_w;
    Estimate energy_mj;  ///< of the run
};

/// Of a run with at least a cycle.
RunPower power_of(RunStatistics const& run, PowerCoefficients const& coefficients = {});

}  // namespace dataflow
