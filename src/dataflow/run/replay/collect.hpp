#pragma once
#include <vector>

#include "dataflow/base/core_share.hpp"
#include "dataflow/core/machine/machine.hpp"
#include "dataflow/core/memory/memory_load.hpp"
#include "dataflow/core/time/core_timing.hpp"
#include "dataflow/run/figures/run_statistics.hpp"

namespace dataflow::replay {

/// A core that has done all it can.
struct FinishedCore {
    CoreShare share;
    timing::CoreTiming& timing;
    Counters const* counters;  ///< by sample of its share, as far as it got
};

/// How long it takes to bring what a machine's memories on the chip hold. As many copies of what cores share as it has:
/// the ranges may be those of another.
Cycles load_cycles(Machine const& machine, std::vector<timing::LoadedRange> loaded);

/// The figures of a finished (or stuck) run of a machine. `memory`: the external one; null if it is ideal. `loaded`:
/// what it brought before cycle 0, which adds to the total. `others`: cycles that cores take which are not among these.
RunStatistics collect(std::vector<FinishedCore> const& cores, Machine const& machine,
                      timing::MemorySystem const* memory = nullptr, std::vector<timing::LoadedRange> const& loaded = {},
                      Cycles others = 0);

}  // namespace dataflow::replay
