#pragma once
#include <cstdint>

#include "timing/process_timing.hpp"

namespace faster::retiming {

/// Whether a process can do operations one after the other: what is read from a file may say anything.
class OperationCheck {
  public:
    explicit OperationCheck(timing::ProcessTiming const& process) : process_(&process) {}

    bool accepts(timing::Operation const& operation);
    /// All it entered it left, and all it began it awaited.
    bool is_done() const { return !in_loop && setups == 0; }

    bool in_loop = false;
    std::int64_t setups = 0;  ///< begun and not awaited
    bool stamped = false;     ///< once per sample at most

    /// Whether a process is in a loop where it does an operation.
    static bool is_in_loop_at(timing::Operation const& operation);

  private:
    bool has_ports(unsigned ports) const { return (ports >> process_->port_count()) == 0; }
    bool accepts_mix(timing::Operation const& operation) const;
    bool accepts_wait(timing::Operation const& operation);

    timing::ProcessTiming const* process_;
};

}  // namespace faster::retiming
