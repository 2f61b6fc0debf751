#pragma once
#include "channels/simulated_design.hpp"
#include "faster/data/stimulus.hpp"
#include "faster/dataflow_names.hpp"
#include "modules/core/core_context.hpp"
#include "modules/core/workload_iterations.hpp"

namespace faster {

/// What raster cores work on, and who watches them.
struct FasterWorkload final : Workload {
    Stimulus stimulus;
    std::vector<std::string> notes;  ///< of warnings()
    SampleProbe* probe = nullptr;    ///< may be null

    std::size_t samples() const override { return stimulus.samples.size(); }
    LoopIterations iterations() const override { return loop_iterations(stimulus); }
    std::vector<std::string> warnings() const override { return notes; }
    std::string table() const override;
    bool leaves_figures_alone() const override { return probe == nullptr; }
};

/// FASTER for the commands that any design has.
class FasterSimulation final : public SimulatedDesign {
  public:
    std::unique_ptr<Workload> load_workload(LoadedConfig& loaded) const override;
    std::unique_ptr<DataflowAccelerator> elaborate(RunConfig const& config, std::shared_ptr<Machine const> machine,
                                                   Workload& workload) const override;
};

}  // namespace faster
