#pragma once
#include "channels/simulate.hpp"
#include "channels/simulated_design.hpp"
#include "dataflow/run/config/load_config.hpp"

namespace dataflow {

/// Elaborates the program's design for a workload, runs it, and collects its figures. Once per process: the SystemC
/// kernel elaborates once. Throws InputError if there is too little memory for it.
RunStatistics simulate(RunConfig const& config, Workload& workload, SimulationOptions const& options = {});

/// The figures of a run of a configuration, whose workload is made for it and is not wanted otherwise. Says what is to
/// be warned of in it.
RunStatistics simulate(LoadedConfig& loaded, SimulationOptions const& options = {});

}  // namespace dataflow
