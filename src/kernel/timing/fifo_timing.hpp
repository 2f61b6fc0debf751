#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/base/cycles.hpp"

namespace faster::timing {

/// What a FIFO is, as far as time is concerned.
struct FifoShape {
    static constexpr std::uint64_t unlimited = std::uint64_t{1} << 48;

    std::string name;
    std::uint64_t capacity = 2;  ///< C: tokens that fit; `unlimited` or more: never full
    Cycles read_latency = 1;     ///< Lf: a token written in cycle s can be read from s + Lf on
    Cycles write_latency = 0;    ///< Lw: stage of the writing loop in which a token leaves; 0 outside loops
    Cycles issue_latency = 0;    ///< stages of a flushing pipeline in front of the FIFO, which hold tokens of their own

    bool is_unlimited() const { return capacity >= unlimited; }
};

/// The cycle of every access to one clocked FIFO (SPEC section 3): the n-th write happens at s_n >= r_(n-C) + 1, the
/// n-th read at r_n >= s_n + Lf. Knows no data and no SystemC. Accesses are entered in order, each side on its own; a
/// side may run ahead of the other only as far as these rules let it know its earliest legal cycle.
///
/// With an issue latency (area_reciprocal) the writer enters the cycle in which it issues a token; the token counts as
/// written issue_latency cycles later, and the pipeline's stages add to the room: issue_n >= r_(n-C-issue_latency) + 1.
class FifoTiming {
  public:
    explicit FifoTiming(FifoShape shape);

    std::string const& name() const { return shape_.name; }
    FifoShape const& shape() const { return shape_; }
    std::uint64_t writes() const { return passed_ + writes_ - first_token; }
    std::uint64_t reads() const { return passed_ + reads_ - first_token; }
    std::uint64_t max_occupancy() const { return max_occupancy_; }
    Cycles full_stall_cycles() const { return full_stall_cycles_; }
    Cycles empty_stall_cycles() const { return empty_stall_cycles_; }

    bool is_unlimited() const { return shape_.is_unlimited(); }
    /// Of an unlimited FIFO, whose writer has got ahead of its reader as far as cycles can be kept: makes room for
    /// more.
    void keep_more();

    /// Number of further writes (reads) whose earliest legal cycle is known by now.
    std::uint64_t known_writes() const { return room_ - (writes_ - reads_); }
    std::uint64_t known_reads() const { return writes_ - reads_; }

    /// Earliest legal cycle of the i-th next write (read); i below known_writes() (known_reads()).
    Cycles earliest_write(std::uint64_t i = 0) const { return free_from_[(writes_ + i - room_) & index_mask_]; }
    Cycles earliest_read(std::uint64_t i = 0) const { return readable_from_[(reads_ + i) & index_mask_]; }

    /// Enters the next write (read) in `cycle`, which must be legal. O(1), the largest occupancy included.
    void write(Cycles cycle) {
        readable_from_[writes_ & index_mask_] = cycle + later_than_write();
        note_write(cycle + shape_.issue_latency);
    }
    void read(Cycles cycle) {
        free_from_[freed_at_ + (reads_ & index_mask_)] = cycle + 1;
        note_read(cycle);
    }

    /// The next writes (reads) of a run: the i-th, i below known_writes() (known_reads()), is legal from earliest(i) on
    /// and happens in the cycle that is entered. Of no effect until done() with as many as were entered.
    template <bool Writes> class Run {
      public:
        Run() = default;
        explicit Run(FifoTiming& fifo)
            : earliest_(Writes ? fifo.free_from_.data() : fifo.readable_from_.data()),
              entered_(Writes ? fifo.readable_from_.data() : fifo.free_from_.data() + fifo.freed_at_),
              at_(Writes ? fifo.writes_ : fifo.reads_),
              behind_(Writes ? fifo.room_ : 0),
              mask_(fifo.index_mask_),
              later_(Writes ? fifo.later_than_write() : 1) {}
        Cycles earliest(std::uint64_t i) const { return earliest_[(at_ - behind_ + i) & mask_]; }
        void enter(std::uint64_t i, Cycles cycle) { entered_[(at_ + i) & mask_] = cycle + later_; }
        /// `count` accesses from the i-th on, one every `stride` cycles.
        void enter_every(Cycles stride, std::uint64_t i, std::uint64_t count, Cycles cycle) {
            for (std::uint64_t const end = i + count; i != end; ++i, cycle += stride)
                enter(i, cycle);
        }
        /// So many cycles later than the one that is `before` accesses before it.
        void repeat(std::uint64_t i, std::uint64_t before, Cycles later) {
            entered_[(at_ + i) & mask_] = entered_[(at_ + i - before) & mask_] + later;
        }

      private:
        Cycles const* earliest_ = nullptr;
        Cycles* entered_ = nullptr;
        std::uint64_t at_ = 0;
        std::uint64_t behind_ = 0;
        std::uint64_t mask_ = 0;
        Cycles later_ = 0;
    };
    void done(Run<true> const& /*writes*/, std::uint64_t count);
    void done(Run<false> const& /*reads*/, std::uint64_t count);

    void add_full_stall(Cycles cycles) { full_stall_cycles_ += cycles; }
    void add_empty_stall(Cycles cycles) { empty_stall_cycles_ += cycles; }

  private:
    friend class SteadyState;
    friend class RelativeState;

    Cycles later_than_write() const { return shape_.issue_latency + shape_.read_latency; }

    /// Counts the next write, which the ring holds already, and the largest occupancy.
    void note_write(Cycles written) {
        // Pair (n - M, n): M tokens before this one, the oldest of them still inside at the end of this cycle? Pairs
        // whose read is not known yet are looked at when it is. Right with any M that was reached before, as well as
        // with the largest: who needs the largest of a while begins it with none.
        for (std::uint64_t m = std::max(max_occupancy_, writes_ - reads_ + 1);
             m < shape_.capacity && free_from_[(writes_ - m) & index_mask_] > written + 1;)
            max_occupancy_ = ++m;
        ++writes_;
        max_occupancy_ = max_occupancy_ == 0 ? 1 : max_occupancy_;  // a token stays for a cycle at least (Lf >= 1)
    }
    void note_read(Cycles cycle) {
        while (max_occupancy_ < shape_.capacity && reads_ + max_occupancy_ < writes_ &&
               readable_from_[(reads_ + max_occupancy_) & index_mask_] < cycle + shape_.read_latency)
            ++max_occupancy_;
        ++reads_;
    }

    /// Tokens are numbered from here, so that one has others before it: read long ago, as the rings say.
    static constexpr std::uint64_t first_token = std::uint64_t{1} << 32;

    FifoShape shape_;
    std::uint64_t room_;          // capacity and pipeline stages; unlimited: tokens of which cycles are kept
    std::uint64_t index_mask_;    // rings of the last accesses; a power of two above room_
    std::uint64_t freed_at_ = 0;  // in free_from_: where reads are entered
    std::uint64_t writes_ = first_token;
    std::uint64_t reads_ = first_token;
    std::uint64_t passed_ = 0;     // tokens counted elsewhere, written and read
    std::uint64_t max_occupancy_;  // unlimited: not looked for
    Cycles full_stall_cycles_ = 0;
    Cycles empty_stall_cycles_ = 0;
    std::vector<Cycles> readable_from_;  // of write n: s_n + Lf
    std::vector<Cycles> free_from_;      // of read n: r_n + 1; zero before the first read. Unlimited: zeros, as nobody
                                         // ever waits for room, and behind them what reads enter
};

/// Both times that decide a new largest occupancy never fall from one token to the next: most runs have none, as the
/// last token before theirs shows.
inline void FifoTiming::done(Run<true> const& /*writes*/, std::uint64_t count) {
    std::uint64_t const end = writes_ + count;
    Cycles const first = readable_from_[writes_ & index_mask_] - shape_.read_latency;
    std::uint64_t const before_last = std::min(end - 1 - max_occupancy_, reads_ - 1);
    bool const may_raise = max_occupancy_ < shape_.capacity && free_from_[before_last & index_mask_] > first + 1;
    if (!may_raise && max_occupancy_ > 0) {
        writes_ = end;
        return;
    }
    while (writes_ != end)
        note_write(readable_from_[writes_ & index_mask_] - shape_.read_latency);
}

inline void FifoTiming::done(Run<false> const& /*reads*/, std::uint64_t count) {
    std::uint64_t const end = reads_ + count;
    Cycles const last = free_from_[(end - 1) & index_mask_] - 1;
    bool const may_raise = max_occupancy_ < shape_.capacity && reads_ + max_occupancy_ < writes_ &&
                           readable_from_[(reads_ + max_occupancy_) & index_mask_] < last + shape_.read_latency;
    if (!may_raise) {
        reads_ = end;
        return;
    }
    while (reads_ != end)
        note_read(free_from_[reads_ & index_mask_] - 1);
}

}  // namespace faster::timing
