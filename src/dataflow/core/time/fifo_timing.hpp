#pragma once
#include <cstdint>
#include <string>

#include "dataflow/core/time/cycle_ring.hpp"
#include "dataflow/core/time/fifo_rules.hpp"

namespace dataflow::timing {

/// The cycle of every access to one clocked FIFO of a core, and what is counted of them. Knows no data and no SystemC.
/// Accesses are entered in order, each side on its own; a side may run ahead of the other only as far as FifoRules let
/// it know its earliest legal cycle.
class FifoTiming {
  public:
    using End = FifoEnd<CycleRing>;

    explicit FifoTiming(FifoShape shape);
    /// A process's end of the external memory, which is at the other one: see MemoryStream.
    static FifoTiming of_memory(std::string name, bool writes);

    std::string const& name() const { return shape_.name; }
    FifoShape const& shape() const { return shape_; }
    std::uint64_t writes() const { return passed_ + rules_.free.consumed(); }
    std::uint64_t reads() const { return passed_ + rules_.readable.consumed(); }
    std::uint64_t max_occupancy() const { return max_occupancy_; }
    /// When all is done: tokens that nobody reads are counted then only.
    std::uint64_t final_max_occupancy() const { return std::max(max_occupancy_, writes() - reads()); }
    Cycles full_stall_cycles() const { return full_stall_cycles_; }
    Cycles empty_stall_cycles() const { return empty_stall_cycles_; }

    bool is_unlimited() const { return shape_.is_unlimited(); }
    /// Makes room for more cycles: of an unlimited FIFO, whose writer is ahead of its reader by all that is kept.
    void keep_more();

    /// Number of further writes (reads) whose earliest legal cycle is known by now.
    std::uint64_t known_writes() const { return rules_.free.known(); }
    std::uint64_t known_reads() const { return rules_.readable.known(); }

    /// Earliest legal cycle of the i-th next write (read); i below known_writes() (known_reads()).
    Cycles earliest_write(std::uint64_t i = 0) const { return rules_.free[i]; }
    Cycles earliest_read(std::uint64_t i = 0) const { return rules_.readable[i]; }

    /// Enters the next write (read) in `cycle`, which must be legal.
    void write(Cycles cycle) {
        rules_.writer().access(cycle);
        note_writes(1);
    }
    void read(Cycles cycle) {
        rules_.reader().access(cycle);
        note_reads(1);
    }

    /// For who enters many: the end, and what to call behind as many writes (reads) as were entered.
    End end(bool writes) { return writes ? rules_.writer() : rules_.reader(); }
    void note(bool writes, std::uint64_t count) { writes ? note_writes(count) : note_reads(count); }

    bool is_stream() const { return is_stream_; }
    /// Of what a process reads from memory: its next tokens, each of which can be read from the cycle that `next()`
    /// gives on. Makes room where it is needed.
    template <class Next> void deliver(std::uint64_t tokens, Next next) {
        while (rules_.free.known() + rules_.readable.known() + tokens > rules_.room)
            make_room();
        rules_.readable.append(tokens, next);
    }
    /// The cycle after each was taken, earliest_write(), need not be kept.
    void forget_taken(std::uint64_t tokens) { rules_.free.consume(tokens); }

    void add_stall(bool writes, Cycles cycles) { (writes ? full_stall_cycles_ : empty_stall_cycles_) += cycles; }

    /// For who remembers answers: see lookup_view.hpp.
    class View;

  private:
    /// Both times that decide a new largest occupancy never fall from one token to the next: most runs have none, as
    /// the last token before theirs shows.
    void note_writes(std::uint64_t count) {
        std::uint64_t const first = 0 - count;  // from the fronts on: they are behind the writes now
        Cycles const after = written(first) - rules_.read_latency + rules_.later_than_read;
        std::uint64_t const last = std::min(rules_.room - max_occupancy_, known_writes()) - 1;
        if (max_occupancy_ == 0 || (max_occupancy_ < rules_.capacity && rules_.free[last] > after))
            look_at_writes(first);
    }
    void note_reads(std::uint64_t count) {
        std::uint64_t const first = 0 - count;
        Cycles const last = rules_.free[known_writes() - 1] - rules_.later_than_read;
        if (max_occupancy_ < rules_.capacity && max_occupancy_ < known_reads() + count &&
            rules_.readable[first + max_occupancy_] < last + rules_.read_latency)
            look_at_reads(first);
    }
    /// When the token of the i-th write from here on can be read.
    Cycles written(std::uint64_t i) const { return rules_.readable[known_reads() + i]; }
    void look_at_writes(std::uint64_t first);
    void look_at_reads(std::uint64_t first);
    void make_room();

    FifoShape shape_;
    FifoRules<CycleRing> rules_;
    std::uint64_t passed_ = 0;         // tokens counted elsewhere, written and read
    std::uint64_t max_occupancy_ = 0;  // unlimited: not looked for
    Cycles full_stall_cycles_ = 0;
    Cycles empty_stall_cycles_ = 0;
    bool is_stream_ = false;
};

}  // namespace dataflow::timing
