#pragma once
#include <memory>

#include "channels/dataflow_accelerator.hpp"
#include "channels/simulate.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/raster_core.hpp"

namespace faster {

/// The raster cores of a configuration, for a stimulus; both must outlive them. `machine`: of that configuration.
std::unique_ptr<DataflowAccelerator> make_accelerator(AcceleratorConfig const& config, Stimulus const& stimulus,
                                                      std::shared_ptr<Machine const> machine, Engine engine,
                                                      SampleProbe* probe = nullptr);

/// Builds them, runs them until nothing moves, and collects their figures. `probe` sees the maps of every sample; it
/// may be null. Once per process: the SystemC kernel elaborates once.
RunStatistics simulate(AcceleratorConfig const& config, Stimulus const& stimulus, Engine engine,
                       SimulationOptions const& options = {}, SampleProbe* probe = nullptr);

}  // namespace faster
