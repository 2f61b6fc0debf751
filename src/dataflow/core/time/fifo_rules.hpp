#pragma once
#include <algorithm>
#include <cstdint>
#include <string>

#include "dataflow/base/cycles.hpp"

namespace dataflow::timing {

/// What a FIFO is, as far as time is concerned.
struct FifoShape {
    static constexpr std::uint64_t unlimited = std::uint64_t{1} << 48;

    std::string name;
    std::uint64_t capacity = 2;  ///< C: tokens that fit; `unlimited` or more: never full
    Cycles read_latency = 1;     ///< Lf: a token written in cycle s can be read from s + Lf on
    Cycles room_latency = 1;     ///< of a token read in cycle r another can take the place from r + this on
    Cycles write_latency = 0;    ///< Lw: stage of the writing loop in which a token leaves; 0 outside loops
    Cycles read_stage = 0;       ///< stage of the reading loop in which a token is taken; 0 outside loops
    Cycles issue_latency = 0;  ///< stages of a squeezing pipeline in front of the FIFO, which hold tokens of their own
    Cycles flushing_stages = 0;  ///< of a pipeline in front of it that freezes as a whole: see FlushingPipeline

    bool is_unlimited() const { return capacity >= unlimited; }
};

/// One end of a FIFO, its writer's or its reader's. The FIFO is two lines of cycles: from when on its tokens can be
/// read, and from when on there is room for the next writes. A write takes a cycle from the line of room, and appends
/// the cycle from which on its token can be read to the other line. A read does it the other way round.
template <class Line> struct FifoEnd {
    Line* consumes = nullptr;
    Line* appends = nullptr;
    typename Line::Time later = 0;  ///< than the access: what is appended

    /// Accesses to come whose earliest legal cycle is known.
    std::uint64_t known() const { return consumes->known(); }
    typename Line::Time earliest() const { return (*consumes)[0]; }
    void access(typename Line::Time cycle) const {
        consumes->consume(1);
        appends->append(cycle + later);
    }
};

/// The rules of a clocked FIFO (docs/timing-model.md#fifos): the n-th write happens at s_n >= r_(n-C) + 1, the n-th
/// read at r_n >= s_n + Lf. With an issue latency (of a pipeline that squeezes) the writer says when it issues a token.
/// The token counts as written issue_latency cycles later, and the stages of the pipeline add to the room: issue_n >=
/// r_(n-C-issue_latency) + 1.
///
/// `Line` is how cycles are held: absolute ones of 64 bits in a ring, for a core (CycleRing), or relative ones of 32
/// bits, for what is looked up (BenchLine). line[i] is the i-th cycle from the front on; negative: one consumed before.
template <class Line> struct FifoRules {
    using Time = typename Line::Time;

    FifoRules(FifoShape const& shape, std::uint64_t room_for)
        : capacity(shape.capacity),
          room(room_for),
          read_latency(static_cast<Time>(shape.read_latency)),
          later_than_write(static_cast<Time>(shape.issue_latency + shape.read_latency)),
          later_than_read(static_cast<Time>(shape.room_latency)),
          readable(room),
          free(room) {}

    static std::uint64_t room_of(FifoShape const& shape) { return shape.capacity + shape.issue_latency; }

    FifoEnd<Line> writer() { return {&free, &readable, later_than_write}; }
    FifoEnd<Line> reader() { return {&readable, &free, later_than_read}; }

    /// The number of tokens in the FIFO at the end of a cycle is what a pair of a write and a read shows: of the write
    /// of token n and the read of token n - m, which happens later, that there were m + 1. Pairs whose read is not
    /// known when the write is looked at are found when the read is.
    ///
    /// `largest`, raised by the write whose token can be read from `readable_from` on. `freed(i)` is the i-th cycle of
    /// the line of room from that write on, of which `known` are known.
    template <class Freed>
    std::uint64_t raised_by_write(std::uint64_t largest, Time readable_from, std::uint64_t known, Freed freed) const {
        Time const after = readable_from - read_latency + later_than_read;
        for (std::uint64_t m = std::max(largest, room + 1 - known); m < capacity && freed(room - m) > after;)
            largest = ++m;
        return std::max<std::uint64_t>(largest, read_latency > 0 ? 1 : 0);  // it stays for a cycle at least
    }
    /// `largest`, raised by the read in a cycle. `readable_at(i)`: the i-th cycle of readable from that read on.
    template <class ReadableAt>
    std::uint64_t raised_by_read(std::uint64_t largest, Time cycle, std::uint64_t known, ReadableAt readable_at) const {
        while (largest < capacity && largest < known && readable_at(largest) < cycle + read_latency)
            ++largest;
        return largest;
    }

    std::uint64_t capacity;
    std::uint64_t room;  ///< capacity and pipeline stages; of an unlimited FIFO: tokens of which cycles are kept
    Time read_latency;
    Time later_than_write;
    Time later_than_read;
    Line readable;  ///< from when on tokens can be read
    Line free;      ///< from when on there is room for a write
};

}  // namespace dataflow::timing
