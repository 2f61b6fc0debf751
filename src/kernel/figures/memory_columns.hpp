#pragma once
#include "kernel/base/column.hpp"
#include "kernel/base/cycles.hpp"
#include "kernel/machine/block_ram.hpp"

namespace faster {

/// One row of the table of block RAMs in summary.json: a memory of a core.
struct MemoryRow : MemoryShape {
    std::uint64_t core = 0;
    std::string bram;
    Cycles port_conflict_cycles = 0;
    bool decides_intervals = true;  ///< its ports do; not those of line buffers, which a loop shifts

    std::uint64_t ports_of_bank() const { return ports / partition; }
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
     WrittenTo::json},
    {"ports", "-", &MemoryRow::ports_of_bank, Tells::shape, "of a bank, as configured", nullptr, WrittenTo::budgets},
    {"ramb36", "RAMB36", &MemoryRow::ramb36, Tells::shape, "36 Kbit block RAMs that it takes, all buffers together",
     nullptr, WrittenTo::json},
    {"port_conflict_cycles", "cycles", &MemoryRow::port_conflict_cycles, Tells::work, "of the loops that it limits",
     nullptr, WrittenTo::json_and_budgets},
};

}  // namespace faster
