#pragma once
#include <memory>
#include <utility>

#include "channels/simulated_design.hpp"
#include "kernel/config/simple_design.hpp"

namespace faster {

/// What one core of a simple design is made of; passed on to SimpleCore.
struct SimpleCoreParts {
    sc_core::sc_module_name name;  ///< has to live until the core is complete: what is made meanwhile belongs to it
    Numbers const& numbers;
    std::shared_ptr<Machine const> machine;
    CoreShare share;
    TimeBase const& time_base;
};

/// A core of a simple design. The derived class has modules and FIFOs as members and binds them, see DataflowCore, and
/// describes itself: `static CoreDescription describe(Numbers const&)`.
class SimpleCore : public DataflowCore {
  public:
    explicit SimpleCore(SimpleCoreParts const& parts)
        : DataflowCore(parts.name, parts.machine, parts.share, parts.time_base), numbers_(parts.numbers) {}

    /// What the configuration says of the design's numbers.
    Numbers const& numbers() const { return numbers_; }

  private:
    Numbers const& numbers_;
};

/// All that the commands ask of a simple design whose cores are `Core`s. A program makes one, and says so:
///
///     SimpleSimulation<MyCore> const& my_design() {
///         static SimpleSimulation<MyCore> const one({"my_design", {{"workload.length", 100, "Numbers of a
///         sample."}}}); return one;
///     }
///     faster::Design const& faster::design() { return my_design(); }
///     faster::SimulatedDesign const& faster::simulated_design() { return my_design(); }
template <class Core> class SimpleSimulation final : public SimpleDesign, public SimulatedDesign {
  public:
    using SimpleDesign::SimpleDesign;

    std::unique_ptr<Workload> load_workload(LoadedConfig& loaded) const override {
        return std::make_unique<SampleCount>(numbers_of(loaded.config)["workload.samples"]);
    }

    std::unique_ptr<DataflowAccelerator> elaborate(RunConfig const& config, std::shared_ptr<Machine const> machine,
                                                   Workload& workload) const override {
        auto const make_core = [&config](char const* name, std::shared_ptr<Machine const> const& of, CoreShare share,
                                         TimeBase const& time_base) {
            return std::make_unique<Core>(SimpleCoreParts{name, numbers_of(config), of, share, time_base});
        };
        return std::make_unique<DataflowAccelerator>("accelerator", std::move(machine), workload.samples(),
                                                     config.simulation.engine, make_core);
    }

  protected:
    CoreDescription describe(Numbers const& numbers) const override { return Core::describe(numbers); }

  private:
    struct SampleCount final : Workload {
        explicit SampleCount(std::size_t number) : samples_(number) {}
        std::size_t samples() const override { return samples_; }
        std::size_t samples_;
    };
};

}  // namespace faster
