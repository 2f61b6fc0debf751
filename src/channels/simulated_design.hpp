#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "channels/dataflow_accelerator.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/run/config/load_config.hpp"

namespace dataflow {

/// About how many iterations all loops of all cores make together.
struct LoopIterations {
    double alike = 0;  ///< one as the other, which the engine `decoupled` does many at a time
    double other = 0;

    double all() const { return alike + other; }
};

/// What the cores of a design work on, made as its configuration says. Every design derives one.
class Workload {
  public:
    virtual ~Workload() = default;
    virtual std::size_t samples() const = 0;
    /// What in it looks like a mistake, a line each.
    virtual std::vector<std::string> warnings() const { return {}; }
    /// To say beforehand how long a run is; none: no idea, and its first samples are timed.
    virtual LoopIterations iterations() const { return {}; }
    /// What it is made of as a table, for Design::workload_table(). Empty: not known.
    virtual std::string table() const { return {}; }
    /// Whether modules leave nothing behind but results and figures, so that cores may run in processes of their own.
    virtual bool leaves_figures_alone() const { return false; }
};

/// What simulating a design takes, besides what Design says of it. A program has one: whoever builds the program
/// defines simulated_design().
class SimulatedDesign {
  public:
    virtual ~SimulatedDesign() = default;
    /// What is recorded may decide keys of the configuration: they are changed then. Throws InputError.
    virtual std::unique_ptr<Workload> load_workload(LoadedConfig& loaded) const = 0;
    /// The SystemC modules of a configuration, which must outlive them, as must the others.
    virtual std::unique_ptr<DataflowAccelerator> elaborate(RunConfig const& config,
                                                           std::shared_ptr<Machine const> machine,
                                                           Workload& workload) const = 0;
};

/// The design of this program.
SimulatedDesign const& simulated_design();

}  // namespace dataflow
