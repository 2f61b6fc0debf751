#pragma once
#include <cstdint>
#include <vector>

#include "kernel/base/column.hpp"
#include "kernel/base/cycles.hpp"

namespace faster {

/// What a sample's result consists of, in the order of Design::counters().
using Counters = std::vector<std::uint64_t>;

/// One row of samples.csv.
struct SampleStatistics {
    std::uint64_t sample = 0;
    std::uint64_t core = 0;
    Cycles start_cycle = 0;
    Cycles end_cycle = 0;
    Counters counters;

    Cycles latency_cycles() const { return end_cycle + 1 - start_cycle; }
};

/// The columns of samples.csv before those of the counters.
inline constexpr Column<SampleStatistics> sample_columns[]{
    {"sample", "-", &SampleStatistics::sample, Tells::key, "index, 0, 1, 2, ... over all cores"},
    {"core", "-", &SampleStatistics::core, Tells::when, "that scored it"},
    {"start_cycle", "cycle", &SampleStatistics::start_cycle, Tells::when, "in which it starts"},
    {"end_cycle", "cycle", &SampleStatistics::end_cycle, Tells::when, "in which it ends"},
    {"latency_cycles", "cycles", &SampleStatistics::latency_cycles, Tells::when,
     "end + 1 - start, queueing included. Samples of a core overlap: latencies do not add up to `total_cycles`"},
};

}  // namespace faster
