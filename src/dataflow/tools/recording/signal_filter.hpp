#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "dataflow/core/machine/machine.hpp"

namespace dataflow::recording {

/// Which parts of a machine's cores are to be shown: those whose name matches one of some glob patterns, and the FIFOs
/// at a module's ends and the block RAMs inside it with the module. The external memory is named "memory". Without
/// patterns: all.
class SignalFilter {
  public:
    /// Errors: InputError if a pattern matches nothing that the machine has.
    SignalFilter(std::vector<std::string> const& patterns, Machine const& machine);
    /// FIFOs and nothing else.
    static SignalFilter fifos(Machine const& machine);

    /// By number in the machine.
    bool shows_process(std::size_t process) const { return processes_[process]; }
    bool shows_fifo(std::size_t fifo) const { return fifos_[fifo]; }
    bool shows_memory(std::size_t memory) const { return memories_[memory]; }
    bool shows_external_memory() const { return external_memory_; }
    bool shows_samples() const { return samples_; }

  private:
    SignalFilter() = default;

    std::vector<bool> processes_;
    std::vector<bool> fifos_;
    std::vector<bool> memories_;
    bool external_memory_ = false;
    bool samples_ = true;
};

}  // namespace dataflow::recording
