#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/core/machine/machine.hpp"

namespace dataflow::recording {

/// One access of a memory port, as the static schedule of a loop iteration has it.
struct PortAccess {
    std::size_t memory = 0;
    /// Of all banks: bank b has ports b * ports .. (b + 1) * ports - 1; then those of the next buffer.
    std::uint64_t port = 0;
    Cycles cycle = 0;
    bool writes = false;  ///< the slot of a write; whether the data let it happen is not looked at
    std::uint64_t address = 0;
    std::size_t buffer = 0;  ///< which of several
};

/// Gives the accesses of one iteration the ports of the machine's memories: accesses to one bank take its ports in
/// turn, a cycle later where there are not enough.
class MemoryPorts {
  public:
    /// `machine` must outlive it.
    explicit MemoryPorts(Machine const& machine) : machine_(machine) {}

    /// Forgets the accesses so far; further ones belong to an iteration that begins in this cycle.
    void begin_iteration(Cycles cycle) {
        cycle_ = cycle;
        accesses_.clear();
    }
    /// `address`: number of a word of the memory, row by row.
    void read(std::size_t memory, std::uint64_t address, std::size_t buffer = 0) {
        add(memory, false, address, buffer);
    }
    void write(std::size_t memory, std::uint64_t address, std::size_t buffer = 0) {
        add(memory, true, address, buffer);
    }
    /// The iteration reads that word already.
    bool has_read(std::size_t memory, std::uint64_t address) const;

    std::vector<PortAccess> const& accesses() const { return accesses_; }

  private:
    void add(std::size_t memory, bool writes, std::uint64_t address, std::size_t buffer);
    std::uint64_t accesses_so_far(std::size_t memory, std::uint64_t bank) const;

    Machine const& machine_;
    Cycles cycle_ = 0;
    std::vector<PortAccess> accesses_;
};

}  // namespace dataflow::recording
