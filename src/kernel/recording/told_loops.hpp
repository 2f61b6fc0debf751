#pragma once
#include <cstdint>
#include <deque>

#include "kernel/timing/process_timing.hpp"

namespace faster::recording {

/// What a process has told of its loops, so that somebody can say in which iteration it stands: the process itself
/// keeps no more of that than decides its times.
class ToldLoops {
  public:
    /// The process has told more. To be called with all that it tells, in order.
    void take(timing::OperationLog const& told);
    /// Iterations that the process has done in the loop it is in, or was in last. It only goes on from there.
    std::uint64_t done_in_loop(timing::ProcessTiming const& process);

  private:
    std::uint64_t iterations_ = 0;          ///< told, of all its loops
    std::deque<std::uint64_t> at_entries_;  ///< as many were told when a loop was entered
};

}  // namespace faster::recording
