#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "dataflow/core/time/fifo_timing.hpp"
#include "dataflow/lookup/state_words.hpp"

namespace dataflow::timing {

/// The cycles from which on the accesses of one side of a FIFO are legal, in order: the other side appends them. Of
/// those that have no effect any more, there are as many before the first as there is room for.
class BenchLine {
  public:
    using Cycle = std::int32_t;
    using Time = std::int64_t;
    using Reader = Cycle const*;
    using Writer = Cycle*;
    static constexpr Cycle over = -(Cycle{1} << 30);
    /// So many behind end() may be looked at, and are nothing.
    static constexpr std::uint64_t slack = 8;

    explicit BenchLine(std::uint64_t most) : before_(most), cycles_(2 * most + 256 + slack, over) {
        place(cycles_.data() + before_, cycles_.data() + before_);
    }
    BenchLine(BenchLine&&) = default;  // what it points to moves along
    BenchLine& operator=(BenchLine&&) = delete;
    BenchLine(BenchLine const&) = delete;
    BenchLine& operator=(BenchLine const&) = delete;
    ~BenchLine() = default;

    /// Takes up a state's times, behind some that are over.
    void load_end(std::uint64_t count_over, Time /*when*/, std::uint64_t count, Time /*base*/,
                  StateWord const* cycles) {
        Cycle* const begin = cycles_.data() + before_;
        place(begin, begin);
        if (count > 0)
            append(cycles, count);
        front_ -= count_over;
        first_ = front_;
        first_end_ = end_;
    }
    void load_front(std::uint64_t count_over, Time when, std::uint64_t count, Time base, StateWord const* cycles) {
        load_end(count_over, when, count, base, cycles);
    }
    /// From here on, consumed() and appended() count.
    void start() {
        if (end_ + room_to_start > limit_)
            move_back();
        first_ = front_;
        first_end_ = end_;
    }

    std::uint64_t known() const { return static_cast<std::uint64_t>(end_ - front_); }
    Cycle operator[](std::uint64_t i) const { return front_[i]; }
    void consume(std::uint64_t count) { front_ += count; }
    void append(Time cycle) {
        reserve(1);
        *end_++ = static_cast<Cycle>(cycle);
    }

    /// Many at once: what is to be consumed, and what is to be appended; the line itself changes with consume() and
    /// done().
    Reader reader() const { return front_; }
    Writer writer(std::uint64_t count) {
        reserve(count);
        return end_;
    }
    void done(std::uint64_t count) { end_ += count; }

    std::uint64_t consumed() const { return static_cast<std::uint64_t>(front_ - first_); }
    std::uint64_t appended() const { return static_cast<std::uint64_t>(end_ - first_end_); }
    /// Those consumed since start(), those that are left behind them, and those appended.
    Cycle const* all() const { return first_; }
    std::uint64_t all_count() const { return static_cast<std::uint64_t>(end_ - first_); }
    Cycle const* fresh() const { return first_end_; }

    /// How many, from the front on, are not after a cycle. They never fall.
    std::uint64_t count_until(std::int64_t cycle) const {
        Cycle const* last = end_;
        while (last != front_ && last[-1] > cycle)
            --last;
        return static_cast<std::uint64_t>(last - front_);
    }

    /// Puts `count` down, relative to a base. By eights, so that a compiler makes few instructions of it: there is room
    /// behind both.
    void copy(std::uint64_t first, std::uint64_t count, Time base, StateWord* to) const {
        auto const origin = static_cast<Cycle>(base);
        Cycle const* const from = front_ + first;
        for (std::uint64_t i = 0; i < count; i += slack)
            for (std::uint64_t k = 0; k < slack; ++k)
                to[i + k] = from[i + k] - origin;
    }

  private:
    static constexpr std::uint64_t room_to_start = 64;

    /// Makes sure that so many can be appended.
    void reserve(std::uint64_t count) {
        if (limit_ - end_ < static_cast<std::ptrdiff_t>(count))
            grow(count);
    }
    void append(StateWord const* cycles, std::uint64_t count) {
        reserve(count);
        end_ = std::copy(cycles, cycles + count, end_);
    }

    void place(Cycle* front, Cycle* end) {
        front_ = first_ = front;
        end_ = first_end_ = end;
        limit_ = cycles_.data() + cycles_.size() - slack;
    }
    /// To the place where it began, unless some of it is still before that.
    void move_back() {
        Cycle* const begin = cycles_.data() + before_;
        if (front_ > begin)
            place(begin, std::copy(front_, end_, begin));
    }
    void grow(std::uint64_t count) {
        auto const at = [this](Cycle const* place) { return place - cycles_.data(); };
        auto const front = at(front_), first = at(first_), first_end = at(first_end_), end = at(end_);
        cycles_.resize(2 * (static_cast<std::uint64_t>(end) + count + slack));
        place(cycles_.data() + front, cycles_.data() + end);
        first_ = cycles_.data() + first;
        first_end_ = cycles_.data() + first_end;
    }

    Cycle* front_ = nullptr;
    Cycle* end_ = nullptr;
    Cycle* limit_ = nullptr;  ///< of end_
    Cycle* first_ = nullptr;
    Cycle* first_end_ = nullptr;
    std::uint64_t before_;  ///< so many at first are `over`, always
    std::vector<Cycle> cycles_;
};

/// A FIFO on the bench: whatever happens to it in one transition, from a state on.
struct BenchFifo : FifoRules<BenchLine> {
    explicit BenchFifo(FifoShape const& shape) : FifoRules(shape, room_of(shape)) {}

    void start() {
        readable.start();
        free.start();
    }

    /// The largest occupancy that shows in what happened since start(), of pairs of a write and a read, one of which
    /// happened since.
    std::uint64_t largest_occupancy() const { return largest_before_reads(largest_behind_writes()); }

  private:
    /// Of reads before start().
    std::uint64_t largest_behind_writes() const {
        std::uint64_t const writes = free.consumed(), known = free.all_count() - free.appended();
        BenchLine::Cycle const* const freed = free.all();
        BenchLine::Cycle const* const written = readable.fresh();  // each readable read_latency later
        std::uint64_t largest = writes > 0 && read_latency > 0 ? 1 : 0;
        // A write behind the last of those reads finds none of them behind it, nor does a later one: times never fall.
        for (std::uint64_t w = 0;
             w < std::min(writes, known) && written[w] - read_latency + later_than_read < freed[known - 1]; ++w)
            largest = raised_by_write(largest, written[w], known - w, [&](std::uint64_t i) { return freed[w + i]; });
        return largest;
    }
    /// Of writes before them, whenever they were.
    std::uint64_t largest_before_reads(std::uint64_t largest) const {
        std::uint64_t const reads = readable.consumed(), known = readable.all_count();
        BenchLine::Cycle const* const readable_from = readable.all();
        BenchLine::Cycle const* const read = free.fresh();  // each later_than_read later
        for (std::uint64_t r = 0; r < reads && r + largest < known && largest < capacity; ++r)
            largest = raised_by_read(largest, read[r] - later_than_read, known - r,
                                     [&](std::uint64_t i) { return readable_from[r + i]; });
        return largest;
    }
};

}  // namespace dataflow::timing
