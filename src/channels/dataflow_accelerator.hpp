#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <systemc>
#include <vector>

#include "channels/dataflow_core.hpp"

namespace faster {

/// All cores of a machine. They share nothing but the list of samples, of which each does a part.
class DataflowAccelerator : public sc_core::sc_module {
  public:
    /// Makes one core. All arguments are for the constructor of DataflowCore.
    using MakeCore = std::function<std::unique_ptr<DataflowCore>(
        char const* name, std::shared_ptr<Machine const> const& machine, CoreShare share, TimeBase const& time_base)>;

    DataflowAccelerator(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> machine,
                        std::size_t samples, Engine engine, MakeCore const& make_core);

    Machine const& machine() const { return *machine_; }
    Engine engine() const { return engine_; }
    std::vector<std::unique_ptr<DataflowCore>> const& cores() const { return cores_; }

    /// Lets simulated time pass until nothing moves any more.
    void run();

  private:
    void let_cores_take_turns();

    std::shared_ptr<Machine const> machine_;
    Engine engine_;
    std::vector<std::unique_ptr<DataflowCore>> cores_;
};

}  // namespace faster
