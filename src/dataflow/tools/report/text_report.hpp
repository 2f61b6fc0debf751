#pragma once
#include <string>

#include "dataflow/tools/report/summary.hpp"

namespace dataflow::report {

/// The report of a run for people: headline, where the cycles went, loops, FIFOs, sample latencies, host speed.
/// Figures of several cores are sums over all of them.
std::string text_report(RunStatistics const& run, HostTime const& host);

/// Who waits for whom when nothing can move: the circle first, then everybody else who is stuck.
std::string deadlock_report(RunStatistics const& run);

}  // namespace dataflow::report
