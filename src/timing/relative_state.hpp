#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "timing/group.hpp"
#include "timing/transition.hpp"

namespace faster::timing {

/// Moves what decides the future of a group between its processes and FIFOs and a list of words. Times in the words are
/// relative to the driver's local time, so that equal lists have equal futures.
class RelativeState {
  public:
    using Words = std::vector<std::int64_t>;
    /// Of the loop a process is in, a state tells up to so many.
    static constexpr std::uint64_t most_iterations = 0xFF;

    /// What the timing of a process cannot tell, as its log may be empty.
    struct Outlook {
        std::uint8_t next_ports = 0;  ///< of the step it goes on with; 0: unknown
        bool frozen = false;          ///< goes on with something outside the group: does not take part any more
    };
    /// Where a follower stands that waits for the driver.
    static constexpr unsigned no_port = ~0U;
    struct Waiting {
        bool waits = false;
        unsigned port = no_port;  ///< what for
        Cycles arrival = 0;       ///< local time at which it reached its step
        Cycles since = 0;         ///< local time at which only the port was left to wait for
    };

    explicit RelativeState(Group const& group) : group_(&group) {}

    std::vector<Outlook>& outlooks() { return outlooks_; }

    /// Charges the followers that wait for the driver with the cycles up to its local time: whatever they wait for
    /// cannot come earlier.
    Waiting park(unsigned member);

    static constexpr std::uint32_t all_logs = ~0U;
    /// False if the driver is in the middle of an iteration. With what the logs of the followers of a mask hold.
    bool save(Words& words, std::uint32_t with_logs) const;
    void clear_logs(std::uint32_t members);
    /// For a group that is only a workbench: empties its logs, and forgets its occupancies. All that happened in it
    /// before must be before `driver_time` and before all times of the words.
    void load(Words const& words, Cycles driver_time);
    /// So that times may begin anew.
    void forget_times();
    /// Tokens read since load().
    static std::size_t loaded_reads(Group::Inner const& inner) {
        return static_cast<std::size_t>(inner.fifo->reads_ - FifoTiming::first_token);
    }
    /// For a group with logs and counters of its own: puts what the processes have yet to do in front of their logs.
    void restore(Words const& words, Cycles driver_time);
    /// The largest distance in time of the saved words.
    std::int64_t reach() const { return reach_; }

    /// The largest occupancy of a FIFO; for a workbench: since load().
    std::uint64_t peak(unsigned fifo) const { return group_->fifos()[fifo].fifo->max_occupancy_; }
    void raise_peak(unsigned fifo, std::uint64_t tokens) {
        std::uint64_t& peak = group_->fifos()[fifo].fifo->max_occupancy_;
        peak = std::max(peak, tokens);
    }

    /// For a workbench: makes the tokens read since load() part of counters().
    void count_tokens();
    /// All that only grows: stalls, loops, tokens gone through.
    std::vector<std::uint64_t*> counters() const;

    bool is_in_loop(unsigned member) const { return process(member).in_loop_; }
    std::uint64_t entries(unsigned member) const { return process(member).loops_entered_; }
    std::uint64_t iterations(unsigned member) const { return process(member).iterations_; }
    void set_iterations(unsigned member, std::uint64_t iterations) { process(member).iterations_ = iterations; }
    /// The port a follower was parked at, before save() or load(), or no_port.
    unsigned parked_at(unsigned member) const { return parked_at_[member]; }
    /// Moves a follower back to when its waiting for a port began.
    void unpark(unsigned member, unsigned port, Cycles arrival, Cycles since);
    /// Cycles from which on there is room in FIFO `f`, and how to set them: see Automaton on frozen writers.
    std::vector<Cycles> room_times(unsigned fifo) const;
    void set_room_time(unsigned fifo, std::uint64_t i, Cycles cycle);

  private:
    /// Times that have no effect any more, of which only the number is saved: in FIFOs where all times are over, they
    /// need not be written.
    enum class Past { is_written, is_over };
    ProcessTiming& process(unsigned member) const { return *group_->members()[member].process; }
    Cycles not_before(unsigned member) const;
    std::uint8_t next_ports(unsigned member) const;
    bool blocked_port(unsigned member, unsigned& port) const;
    bool waits_for_driver(unsigned member, unsigned depth = 0) const;
    static bool known(ProcessTiming const& process, unsigned port);
    static Cycles earliest(ProcessTiming const& process, unsigned port);
    void make_legal(unsigned member, unsigned port, Cycles from);
    void charge(unsigned member, unsigned port, Cycles cycles);
    std::size_t most_words(std::uint32_t with_logs) const;
    class Pen;
    void save_process(unsigned member, bool with_log, Pen& pen) const;
    void save_fifo(Group::Inner const& inner, Cycles reader_floor, Cycles writer_floor, Pen& pen) const;
    void restore(Words const& words, Cycles driver_time, Past past);
    std::int64_t const* restore_process(unsigned member, Cycles base, std::int64_t const* words);
    std::int64_t const* restore_fifo(Group::Inner const& inner, Cycles base, std::int64_t const* words, Past past);

    // The words of a process are its time, one with bit fields (the loop's number in the lowest), its delay line and
    // its log; those of a FIFO one with counts (tokens in the lowest), and times.
    static constexpr unsigned begun_at = 8, next_ports_at = 16, frozen_at = 24, waited_for_at = 32, left_at = 40;
    static constexpr unsigned over_at = 20, room_over_at = 40;
    static constexpr std::uint64_t most_tokens = (1U << 20) - 1;

    Group const* group_;
    std::vector<Outlook> outlooks_{std::vector<Outlook>(group_->members().size())};
    std::vector<unsigned> parked_at_{std::vector<unsigned>(group_->members().size(), no_port)};
    mutable std::int64_t reach_ = 0;
    mutable Words page_;  ///< to write on
};

}  // namespace faster::timing
