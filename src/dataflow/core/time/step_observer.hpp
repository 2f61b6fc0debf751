#pragma once
#include <cstdint>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/time/ports.hpp"

namespace dataflow::timing {

class ProcessTiming;

/// Sees everything that a process does, in the order of its local time but for let_out(). For recordings: an observed
/// process goes step by step.
class StepObserver {
  public:
    virtual ~StepObserver() = default;
    virtual void entered_loop(ProcessTiming const& process, unsigned loop, Cycles cycle) = 0;
    virtual void left_loop(ProcessTiming const& process, Cycles cycle) = 0;
    /// `count` iterations, numbered from `first` on, begin a stride apart, the first of them in `cycle`. An
    /// iteration begins in the stage of its first access: where the loop only writes, when its token leaves.
    virtual void iterated(ProcessTiming const& process, Cycles cycle, std::uint64_t first, std::uint64_t count,
                          Cycles stride) = 0;
    /// Waited for the access of a port in [from, until).
    virtual void stalled(ProcessTiming const& process, unsigned port, Cycles from, Cycles until) = 0;
    virtual void accessed(ProcessTiming const& process, Ports ports, Cycles cycle) = 0;
    /// A token left the process's flushing pipeline by a port in `cycle`, and was due in `due`: between them, the
    /// pipeline stood still. May be told before things that happen earlier, also in a stall for a token to come.
    virtual void let_out(ProcessTiming const& process, unsigned port, Cycles due, Cycles cycle) = 0;
    virtual void stamped(ProcessTiming const& process, Cycles cycle) = 0;
};

}  // namespace dataflow::timing
