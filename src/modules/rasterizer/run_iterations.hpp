#pragma once
#include <cstdint>

#include "dataflow/core/time/ports.hpp"
#include "faster/dataflow_names.hpp"

namespace faster {

/// What iterations of the scan access.
struct ScanPorts {
    timing::Ports fragment;  ///< one that finds a covered pixel
    timing::Ports edge;      ///< one that sends an edge
};

/// A line's run of covered pixels, as iterations.
struct RunIterations {
    int covered;   ///< 1 or more
    bool flushes;  ///< one sends the edge before the run, behind the first covered pixel
    bool leaves;   ///< one sends the edge behind it, then
    int silent;    ///< do nothing
};

/// Tells a clock of them, many at a time. `Clock`: ProcessClock, or what has its iterate(), iterate_with_tail() and
/// iterate_flanked().
template <class Clock> void tell_run(Clock&& clock, ScanPorts const& ports, RunIterations const& run) {
    auto const count = static_cast<std::uint32_t>(run.covered);
    auto const silent = static_cast<std::uint32_t>(run.silent);
    if (run.flushes && run.leaves && count > 1) {
        clock.iterate_flanked(ports.fragment, count, ports.edge, silent);
        return;
    }
    if (run.flushes)
        clock.iterate_with_tail(ports.fragment, 1, ports.edge, 0);
    std::uint32_t const rest = run.flushes ? count - 1 : count;
    if (run.leaves && rest > 0) {
        clock.iterate_with_tail(ports.fragment, rest, ports.edge, silent);
    } else if (run.leaves) {
        clock.iterate(ports.edge, 1);
        clock.iterate(timing::no_ports, silent);
    } else {
        clock.iterate(ports.fragment, rest);
    }
}

}  // namespace faster
