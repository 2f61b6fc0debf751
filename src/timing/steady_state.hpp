#pragma once
#include <cstdint>
#include <deque>
#include <vector>

#include "timing/process_timing.hpp"

namespace faster::timing {

/// Jumps over the boring middle of long regular runs: when processes that only feed each other repeat the same pattern
/// of waits, every further period takes the same cycles, so all of them are added at once. Exact: a period counts as
/// found only if everything that decides the future - local times and FIFO times relative to each other - is the same
/// as one period before.
class SteadyState {
  public:
    /// Iterations left in a run, below which jumping does not pay.
    static constexpr std::uint32_t worthwhile_count = 64;

    /// To be called whenever `process`, one of `processes` of a core, with that much left to do is
    /// about to advance.
    void observe(ProcessTiming& process, std::deque<ProcessTiming>& processes);

  private:
    /// What the processes of a group looked like at one moment.
    struct Snapshot {
        std::vector<std::int64_t> relative;  ///< the same in states with the same future
        std::vector<Cycles> growing;         ///< time and counters; grow by the same amount each period
        std::uint64_t trail_mark = 0;
    };

    void follow(ProcessTiming& process);
    bool find_group(std::deque<ProcessTiming>& processes);
    bool add_neighbours(ProcessTiming const& member, std::deque<ProcessTiming>& processes);
    static std::uint64_t run_of(ProcessTiming const& process);
    static std::uint32_t ports_of(ProcessTiming const& process);
    static std::uint32_t neighbours_of(ProcessTiming const& process);
    static bool accesses(ProcessTiming const& process, FifoTiming const& fifo);
    static void take_pipeline(ProcessTiming const& process, std::vector<std::int64_t>& relative);
    static void shift_pipeline(ProcessTiming& process, std::uint64_t iterations);
    void take(Snapshot& snapshot) const;
    void jump(Snapshot const& now);
    void leave_trail(std::uint64_t periods, Cycles cycles) const;
    bool trail_remembers(Snapshot const& snapshot) const;
    std::uint64_t whole_periods_left(Snapshot const& now) const;
    static void shift(FifoTiming& fifo, std::uint64_t tokens, Cycles cycles);

    std::vector<ProcessTiming*> group_;  // the leader first
    std::vector<FifoTiming*> fifos_;     // between members
    ProcessTiming* leader_ = nullptr;
    std::uint64_t leader_run_ = 0;
    unsigned looks_ = 0;  // at this run so far
    Snapshot before_;
    Snapshot now_;
};

}  // namespace faster::timing
