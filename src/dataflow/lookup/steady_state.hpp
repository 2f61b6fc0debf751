#pragma once
#include <array>
#include <cstdint>
#include <deque>
#include <vector>

#include "dataflow/core/time/lookup_view.hpp"

namespace dataflow::timing {

/// Jumps over the boring middle of long regular runs: when processes that only feed each other repeat the same pattern
/// of waits, every further period takes the same cycles, so all of them are added at once. Exact: a period counts as
/// found only if everything that decides the future - local times and FIFO times relative to each other - is the same
/// as one period before. A deep FIFO that has long been filled (or emptied) far ahead decides nothing: its end is open,
/// and who is at the other end need not repeat itself.
class SteadyState {
  public:
    /// To be called whenever `process`, one of `processes` of a core, with ProcessTiming::long_count iterations left to
    /// do is about to advance. The bits of the processes outside its group that may go on because of it.
    ProcessMask observe(ProcessTiming& process, std::deque<ProcessTiming>& processes);

  private:
    /// What the processes of a group looked like at one moment.
    struct Snapshot {
        std::vector<std::int64_t> relative;  ///< the same in states with the same future
        std::uint64_t trail_mark = 0;

        // What grows by the same amount each period.
        Cycles time = 0;
        struct Done {
            Cycles empty_stalls = 0;
            Cycles full_stalls = 0;
            std::uint64_t iterations = 0;
        };
        std::vector<Done> members;  ///< of the group
        struct Accesses {
            std::uint64_t count = 0;
            Cycles stalls = 0;
        };
        std::vector<Accesses> ends;
    };

    /// Where a member accesses a FIFO.
    struct End {
        ProcessTiming* process;
        unsigned port;
        FifoTiming* fifo;
        bool writes;
        std::uint64_t free;  ///< accesses to come that have nothing to wait for
        bool open() const { return free >= ProcessTiming::long_count; }

        std::uint64_t known() const { return writes ? fifo->known_writes() : fifo->known_reads(); }
        Cycles earliest(std::uint64_t i) const { return writes ? fifo->earliest_write(i) : fifo->earliest_read(i); }
        std::uint64_t accesses() const { return fifo->end(writes).consumes->consumed(); }
        Cycles stalls() const { return writes ? fifo->full_stall_cycles() : fifo->empty_stall_cycles(); }
    };

    /// Accesses before one, in the run of a number, have nothing to wait for.
    struct FreeAccesses {
        std::uint64_t until = 0;
        std::uint64_t in_run = ~std::uint64_t{0};
    };

    bool leads(ProcessTiming& process);
    void give_up();
    bool has_group(std::deque<ProcessTiming>& processes);
    bool find_group(std::deque<ProcessTiming>& processes);
    bool add_ends(ProcessTiming& member, std::deque<ProcessTiming>& processes);
    std::uint64_t free_accesses(End const& end);
    FreeAccesses& known_free(End const& end);
    bool is_between_closed_ends(FifoTiming const& fifo) const;
    static std::uint64_t lags_of(ProcessTiming& process);
    static std::uint64_t first_lag(ProcessTiming& process);
    static Ports ports_of(ProcessTiming& process);
    static bool accesses(ProcessTiming& process, FifoTiming const& fifo);
    static void take_pipeline(ProcessTiming& process, std::vector<std::int64_t>& relative);
    static void shift_pipeline(ProcessTiming& process, std::uint64_t iterations);
    void take(Snapshot& snapshot) const;
    ProcessMask jump(Snapshot const& now);
    void leave_trail(std::uint64_t periods, Cycles cycles) const;
    bool trail_remembers(Snapshot const& snapshot) const;
    std::uint64_t whole_periods_left(Snapshot const& now) const;
    ProcessMask behind_open_ends() const;
    void go_on(End const& end, std::uint64_t accesses, Cycles stalls, std::uint64_t periods, Cycles cycles);
    static void shift(FifoTiming& fifo, std::uint64_t tokens, Cycles cycles);
    static void repeat(ProcessTiming& process, Snapshot::Done const& before, Snapshot::Done const& now,
                       std::uint64_t periods, Cycles cycles);
    static void repeat(End const& end, std::uint64_t accesses, std::uint64_t periods, Cycles cycles);

    std::vector<ProcessTiming*> group_;  // the leader first
    std::vector<End> ends_;
    std::vector<FifoTiming*> fifos_;  // those between closed ends
    ProcessTiming* leader_ = nullptr;
    std::uint64_t leader_run_ = 0;
    unsigned looks_ = 0;                                          // at this run so far
    unsigned others_ = 0;                                         // that went on since the last
    std::array<std::uint64_t, most_processes> given_up_{};        // numbers of runs, by process
    std::array<std::vector<FreeAccesses>, most_processes> free_;  // by process and port
    struct Pause {
        unsigned calls = 0;  ///< twice as many each time, until the group is found
        unsigned left = 0;
    };
    std::array<Pause, most_processes> pauses_{};  // by process
    Snapshot before_;
    Snapshot now_;
};

}  // namespace dataflow::timing
