#pragma once
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "dataflow/core/time/fifo_timing.hpp"
#include "dataflow/core/time/process_timing.hpp"

namespace dataflow::timing {

/// All that who remembers answers sees of the inside of a process: everything that decides what it does next, and what
/// was counted of it. To be read, and changed to what working operations out would have made of it, between two calls
/// of the core.
class ProcessTiming::View {
  public:
    explicit View(ProcessTiming& process) : process_(process) {}

    /// The process by its rules, which save and restore where it stands.
    Rules& rules() const { return process_.rules(); }
    /// How it does what it is told. To be changed before it has done anything.
    ProcessShape const& shape() const { return *process_.shape_; }
    void set_shape(std::shared_ptr<ProcessShape> shape) const { process_.shape_ = std::move(shape); }
    /// Where it stands.
    ProcessState<Cycles>& state() const { return process_.state_; }
    /// Of the loop it is in, or was in last.
    LoopPlan const& plan() const { return *process_.plan_; }
    OperationLog& log() const { return process_.log_; }
    /// A number that no two operations of iterations have.
    std::uint64_t run() const { return process_.run_; }
    ProcessPort& port(unsigned number) const { return process_.ports_[number]; }
    /// The ports that a step accesses together.
    std::vector<ProcessPort> const& port_set(Ports::Number ports) const { return process_.port_set(ports); }

    ProcessFigures& figures() const { return process_.figures_; }
    /// It waits at the step it came to in `arrival`, and has been charged with that up to its local time.
    void waits_since(Cycles arrival) const {
        process_.arrival_ = arrival;
        process_.charged_until_ = process_.state_.time;
    }
    /// It has come to a step in `arrival`, and has not been charged with waiting there.
    void arrived(Cycles arrival) const {
        process_.arrival_ = arrival;
        process_.charged_until_ = never;
    }

  private:
    ProcessTiming& process_;
};

/// What the lookups see and set of a FIFO.
class FifoTiming::View {
  public:
    explicit View(FifoTiming& fifo) : fifo_(fifo) {}

    /// The cycles from which on tokens can be read, and those from which on there is room.
    FifoRules<CycleRing>& rules() const { return fifo_.rules_; }
    std::uint64_t& max_occupancy() const { return fifo_.max_occupancy_; }
    /// Tokens that were written and read without being entered one by one.
    void pass(std::uint64_t tokens) const { fifo_.passed_ += tokens; }

  private:
    FifoTiming& fifo_;
};

}  // namespace dataflow::timing
