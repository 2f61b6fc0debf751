#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <systemc>
#include <vector>

#include "channels/dataflow_core.hpp"
#include "dataflow/core/memory/memory_load.hpp"
#include "dataflow/core/memory/memory_system.hpp"

namespace dataflow {

/// All cores of a machine. They share the list of samples, of which each does a part, and nothing else, unless there is
/// an external memory.
class DataflowAccelerator : public sc_core::sc_module {
  public:
    /// Makes one core. All arguments are for the constructor of DataflowCore.
    using MakeCore = std::function<std::unique_ptr<DataflowCore>(
        char const* name, std::shared_ptr<Machine const> const& machine, CoreShare share, TimeBase const& time_base)>;

    SC_HAS_PROCESS(DataflowAccelerator);
    DataflowAccelerator(sc_core::sc_module_name const& name, std::shared_ptr<Machine const> machine,
                        std::size_t samples, Engine engine, MakeCore const& make_core);

    Machine const& machine() const { return *machine_; }
    Engine engine() const { return engine_; }
    std::vector<std::unique_ptr<DataflowCore>> const& cores() const { return cores_; }

    /// The external memory; null: an ideal one.
    timing::MemorySystem* memory() const { return memory_.get(); }

    /// What is brought from an external memory before cycle 0.
    void load_before(std::vector<timing::LoadedRange> ranges) { loaded_ = std::move(ranges); }
    std::vector<timing::LoadedRange> const& loaded() const { return loaded_; }

    /// Only cores [first, end) do their shares (decoupled, without an external memory). Before run().
    void limit_to(std::size_t first, std::size_t end);
    /// Lets simulated time pass until nothing moves any more.
    void run();
    /// Gives the run up, from inside it. The kernel pauses between two delta cycles, and all of a run of `decoupled`
    /// may be one: so modules begin no further sample.
    void leave() {
        is_left_ = true;
        for (auto const& core : cores_)
            core->leave();
        sc_core::sc_pause();
    }
    bool is_left() const { return is_left_; }

  private:
    static void start();

    void let_cores_share_answers();
    void let_cores_take_turns();
    void join_by_memory(timing::ExternalMemory const& shape);
    void serve_memory();
    void wake(timing::MemorySystem::Target const& target);

    std::shared_ptr<Machine const> machine_;
    Engine engine_;
    std::vector<std::unique_ptr<DataflowCore>> cores_;
    std::unique_ptr<timing::MemorySystem> memory_;
    std::vector<timing::LoadedRange> loaded_;
    bool is_left_ = false;
    std::size_t first_ = 0, end_ = 0;  // cores that do their shares
    sc_core::sc_event memory_asked_{"memory_asked"};
};

}  // namespace dataflow
