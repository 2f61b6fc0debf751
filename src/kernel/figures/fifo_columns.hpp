#pragma once
#include "kernel/base/column.hpp"
#include "kernel/base/cycles.hpp"
#include "kernel/machine/fifo_kind.hpp"

namespace faster {

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

}  // namespace faster
