#pragma once
#include <cstdint>
#include <vector>

#include "dataflow/base/column.hpp"
#include "dataflow/base/cycles.hpp"
#include "dataflow/base/device/block_ram.hpp"
#include "dataflow/core/machine/fifo_kind.hpp"

namespace dataflow {

/// What a FIFO of a core has to tell.
struct FifoStatistics {
    FifoKind kind = FifoKind::shift_register;  ///< as resolved
    std::uint64_t depth = 0;
    std::uint64_t capacity = 0;
    Cycles write_latency = 0;
    std::uint64_t writes = 0;
    std::uint64_t reads = 0;
    Cycles full_stall_cycles = 0;
    Cycles empty_stall_cycles = 0;
    std::uint64_t max_occupancy = 0;
};

/// One row of fifos.csv.
struct FifoRow : FifoStatistics {
    std::uint64_t core = 0;
    std::string fifo;
    std::string kind_name;

    std::string const& name() const { return fifo; }
};

inline constexpr Column<FifoRow> fifo_columns[]{
    {"core", "-", &FifoRow::core, Tells::key, "its core"},
    {"fifo", "-", &FifoRow::fifo, Tells::key, "its name"},
    {"kind", "-", &FifoRow::kind_name, Tells::shape, "`shift_register` or `memory`; `auto` is resolved"},
    {"depth", "tokens", &FifoRow::depth, Tells::shape, "as configured"},
    {"capacity", "tokens", &FifoRow::capacity, Tells::shape, "how many fit", nullptr, WrittenTo::json_and_budgets},
    {"write_latency", "cycles", &FifoRow::write_latency, Tells::shape,
     "stage in which the writing loop sends; 0 where no loop writes"},
    {"writes", "tokens", &FifoRow::writes, Tells::work, "written"},
    {"reads", "tokens", &FifoRow::reads, Tells::work, "read"},
    {"full_stall_cycles", "cycles", &FifoRow::full_stall_cycles, Tells::waiting, "waited by the writer", "fifo_stalls"},
    {"empty_stall_cycles", "cycles", &FifoRow::empty_stall_cycles, Tells::waiting, "waited by the reader",
     "fifo_stalls"},
    {"max_occupancy", "tokens", &FifoRow::max_occupancy, Tells::peak,
     "most tokens written and unread at the end of a cycle", "fifo_occupancies"},
};

/// What a loop of a core has to tell.
struct LoopStatistics {
    Cycles ii_target = 1;
    Cycles ii_recurrence = 1;
    Cycles ii = 1;
    Cycles depth = 1;
    std::uint64_t entries = 0;
    std::uint64_t iterations = 0;
    Cycles port_conflict_cycles = 0;
    Cycles recurrence_cycles = 0;
    std::string limited_by;
    std::string bram;                 ///< that demands most; empty if the loop touches none
    std::uint64_t bram_accesses = 0;  ///< of that, per iteration
    Cycles interlock_cycles = 0;      ///< of recurrence_cycles: waited for writes of iterations before
};

/// One row of loops.csv.
struct LoopRow : LoopStatistics {
    std::uint64_t core = 0;
    std::string module;
    std::string loop;

    std::string name() const { return module + "." + loop; }
};

inline constexpr Column<LoopRow> loop_columns[]{
    {"core", "-", &LoopRow::core, Tells::key, "its core"},
    {"module", "-", &LoopRow::module, Tells::key, "the process that runs it"},
    {"loop", "-", &LoopRow::loop, Tells::key, "its name in the module"},
    {"ii_target", "cycles", &LoopRow::ii_target, Tells::shape, "what the pragma asks for"},
    {"ii_recurrence", "cycles", &LoopRow::ii_recurrence, Tells::shape, "what a dependence between iterations demands"},
    {"ii", "cycles", &LoopRow::ii, Tells::shape, "what is achieved", "loop_intervals"},
    {"depth", "cycles", &LoopRow::depth, Tells::shape, "pipeline stages"},
    {"entries", "-", &LoopRow::entries, Tells::work, "entries with at least one iteration"},
    {"iterations", "-", &LoopRow::iterations, Tells::work, "over all entries", "loop_iterations"},
    {"port_conflict_cycles", "cycles", &LoopRow::port_conflict_cycles, Tells::work, "lost to block RAM ports",
     "loop_losses"},
    {"recurrence_cycles", "cycles", &LoopRow::recurrence_cycles, Tells::work, "lost to the dependence", "loop_losses"},
    {"limited_by", "-", &LoopRow::limited_by, Tells::shape,
     "a block RAM, `recurrence`, or empty; static, also for loops that never ran"},
};

/// One row of the table of block RAMs in summary.json: a memory of a core.
struct MemoryRow : MemoryShape {
    std::uint64_t core = 0;
    std::string bram;
    Cycles port_conflict_cycles = 0;
    bool decides_intervals = true;  ///< its ports do; not those of line buffers, which a loop shifts

    double ramb36() const { return ramb36_count(*this); }
    std::string const& name() const { return bram; }
};

inline constexpr Column<MemoryRow> memory_columns[]{
    {"core", "-", &MemoryRow::core, Tells::key, "its core"},
    {"bram", "-", &MemoryRow::bram, Tells::key, "its name"},
    {"words", "-", &MemoryRow::words, Tells::shape,
     "of each buffer, all banks together; 0: the configuration has no such memory", nullptr, WrittenTo::json},
    {"bits", "bits", &MemoryRow::bits, Tells::shape, "per word", nullptr, WrittenTo::json},
    {"banks", "-", &MemoryRow::partition, Tells::shape, "that share the words", nullptr, WrittenTo::json},
    {"buffers", "-", &MemoryRow::buffers, Tells::shape, "how often all of this is there", nullptr, WrittenTo::json},
    {"ports", "-", &MemoryRow::ports, Tells::shape, "accesses per cycle, of all banks of a buffer together", nullptr,
     WrittenTo::json_and_budgets},
    {"ramb36", "RAMB36", &MemoryRow::ramb36, Tells::shape, "36 Kbit block RAMs that it takes, all buffers together",
     nullptr, WrittenTo::json},
    {"port_conflict_cycles", "cycles", &MemoryRow::port_conflict_cycles, Tells::work, "of the loops that it limits",
     nullptr, WrittenTo::json_and_budgets},
};

/// What a sample's result consists of, in the order of Design::counters().
using Counters = std::vector<std::uint64_t>;

/// One row of samples.csv.
struct SampleStatistics {
    std::uint64_t sample = 0;
    std::uint64_t core = 0;
    Cycles start_cycle = 0;
    Cycles end_cycle = 0;
    Counters counters;

    /// 0 where the module that ends samples is done before the one that begins them.
    Cycles latency_cycles() const { return end_cycle < start_cycle ? 0 : end_cycle + 1 - start_cycle; }
};

/// The columns of samples.csv before those of the counters.
inline constexpr Column<SampleStatistics> sample_columns[]{
    {"sample", "-", &SampleStatistics::sample, Tells::key, "index, 0, 1, 2, ... over all cores"},
    {"core", "-", &SampleStatistics::core, Tells::when, "that scored it"},
    {"start_cycle", "cycle", &SampleStatistics::start_cycle, Tells::when, "in which it starts"},
    {"end_cycle", "cycle", &SampleStatistics::end_cycle, Tells::when, "in which it ends"},
    {"latency_cycles", "cycles", &SampleStatistics::latency_cycles, Tells::when,
     "end + 1 - start, queueing included; 0 if it ends before that. Samples of a core overlap: latencies do not add up "
     "to `total_cycles`"},
};

}  // namespace dataflow
