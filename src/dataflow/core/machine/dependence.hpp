#pragma once
#include <cstddef>
#include <cstdint>

#include "dataflow/base/cycles.hpp"

namespace dataflow {

/// What is done about hazards.
enum class HazardHandling {
    report,     ///< nothing: hardware reads stale words, which reports tell
    interlock,  ///< the iteration waits until the word has been written: time, and comparators
    forward,    ///< what has been written and is not in the memory yet is forwarded to the read: no time, but logic
};

/// What a loop does to a memory from iteration to iteration: each reads words in one stage of the pipeline and writes
/// words in another. An iteration reads a stale word if one shortly before it has yet to write it. HLS does not look
/// out for that where the design says `dependence inter false` (docs/timing-model.md#hazards).
struct MachineDependence {
    std::size_t memory = 0;  ///< its number
    Cycles read_stage = 0;
    Cycles write_stage = 0;
    std::uint64_t reads = 0;  ///< words of an iteration
    std::uint64_t writes = 0;
    HazardHandling handling = HazardHandling::report;
    /// The span if the pipeline is long enough for the stages asked for: no shorter one has a larger span.
    Cycles longest_span = 1;

    /// Cycles that an iteration must begin after one that writes what it reads. A word that is read in the cycle in
    /// which it is written is still the old one. A loop that only writes has nothing to read too early.
    Cycles span() const { return reads > 0 ? write_stage - read_stage + 1 : 1; }
    bool interlocks() const { return handling == HazardHandling::interlock && longest_span > 1; }
    bool is_hazard(std::uint64_t distance, Cycles ii) const { return distance * ii < span(); }
    /// Iterations before it whose writes an iteration may be too early for.
    std::uint64_t reach(Cycles ii) const { return (span() - 1) / ii; }
};

}  // namespace dataflow
