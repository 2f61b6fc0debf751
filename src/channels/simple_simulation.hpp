#pragma once
#include <exception>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "channels/sample_module.hpp"
#include "channels/simulated_design.hpp"
#include "dataflow/base/as_mistake.hpp"
#include "dataflow/base/input_error.hpp"
#include "dataflow/run/config/simple_design.hpp"

namespace dataflow {

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

    /// What comes out of a sample: its counters. The last module tells it at the end of each, if the design has any.
    /// Errors: InputError if it has more or fewer than the design has columns for.
    void add_result(Counters counters) {
        if (std::size_t const columns = dataflow::design().counters().size(); counters.size() != columns)
            throw InputError("a result has " + std::to_string(counters.size()) + " values, expected " +
                             std::to_string(columns) + ", as the design has columns for them");
        results_.push_back(std::move(counters));
    }
    std::size_t results() const override { return has_columns() ? results_.size() : DataflowCore::results(); }
    Counters result(std::size_t i) const override { return has_columns() ? results_[i] : Counters(); }

  private:
    static bool has_columns() { return !dataflow::design().counters().empty(); }

    Numbers const& numbers_;
    std::vector<Counters> results_;
};

/// A module of a simple design. The derived class says in work() what it does for a sample:
///
///     class Counter : public SimpleModule {
///       public:
///         sc_core::sc_fifo_out<int> number_out{"number_out"};
///         static ModuleDescription describe();
///         using SimpleModule::SimpleModule;
///
///       private:
///         void work(std::size_t sample) override;
///     };
class SimpleModule : public SampleModule {
  public:
    SimpleModule(sc_core::sc_module_name const& name, SimpleCore& core) : SampleModule(name, core), core_(core) {}

  protected:
    /// What the configuration says of one of the design's numbers.
    std::uint64_t number(std::string const& key) const { return core_.numbers()[key]; }
    /// What comes out of the sample that ends: see SimpleCore.
    void add_result(Counters counters) { core_.add_result(std::move(counters)); }

  private:
    SimpleCore& core_;
};

/// All that the commands ask of a simple design whose cores are `Core`s. A program makes one, and says so:
///
///     SimpleSimulation<MyCore> const& my_design() {
///         static SimpleSimulation<MyCore> const one({"my_design", {{"workload.length", 100, "Numbers."}}});
///         return one;
///     }
///     dataflow::Design const& dataflow::design() { return my_design(); }
///     dataflow::SimulatedDesign const& dataflow::simulated_design() { return my_design(); }
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
            return of_user("the constructor of the design's core", [&] {
                return std::make_unique<Core>(SimpleCoreParts{name, numbers_of(config), of, share, time_base});
            });
        };
        return std::make_unique<DataflowAccelerator>("accelerator", std::move(machine), workload.samples(),
                                                     config.simulation.engine, make_core);
    }

  protected:
    CoreDescription describe(Numbers const& numbers) const override {
        return of_user("describe() of the design", [&numbers] { return Core::describe(numbers); });
    }

  private:
    /// What the user's code throws is a mistake of the design.
    template <class Call> static auto of_user(char const* which, Call const& call) {
        try {
            return call();
        } catch (...) {
            std::rethrow_exception(thrown_by(which, "it to return"));
        }
    }

    class SampleCount final : public Workload {
      public:
        explicit SampleCount(std::size_t number) : samples_(number) {}
        std::size_t samples() const override { return samples_; }

      private:
        std::size_t samples_;
    };
};

}  // namespace dataflow
