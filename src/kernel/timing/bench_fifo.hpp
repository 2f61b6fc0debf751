#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/timing/fifo_timing.hpp"
#include "kernel/timing/state_words.hpp"

namespace faster::timing {

/// The cycles from which on the accesses of one side of a FIFO are legal, in order: the other side appends them. Of
/// those that have no effect any more, there are as many before the first as there is room for.
class BenchLine {
  public:
    using Cycle = std::int32_t;
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

    void load(std::uint64_t count_over, StateWord const* cycles, std::uint64_t count) {
        Cycle* const begin = cycles_.data() + before_;
        place(begin, begin);
        if (count > 0) {
            reserve(count);
            std::copy(cycles, cycles + count, end_);
            end_ += count;
        }
        front_ -= count_over;
        first_ = front_;
        first_end_ = end_;
    }
    /// From here on, consumed() and appended() count.
    void start() {
        if (end_ + room_to_start > limit_)
            move_back();
        first_ = front_;
        first_end_ = end_;
    }

    std::uint64_t known() const { return static_cast<std::uint64_t>(end_ - front_); }
    /// From the front on; of known() ones.
    Cycle const* cycles() const { return front_; }
    void consume(std::uint64_t count) { front_ += count; }
    /// Makes sure that so many can be appended.
    void reserve(std::uint64_t count) {
        if (limit_ - end_ < static_cast<std::ptrdiff_t>(count))
            grow(count);
    }
    Cycle* end() { return end_; }
    void append(std::uint64_t count) { end_ += count; }

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

  private:
    static constexpr std::uint64_t room_to_start = 64;

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
struct BenchFifo {
    explicit BenchFifo(FifoShape const& shape)
        : capacity(shape.capacity),
          room(shape.capacity + shape.issue_latency),
          read_latency(static_cast<BenchLine::Cycle>(shape.read_latency)),
          later_than_write(static_cast<BenchLine::Cycle>(shape.issue_latency + shape.read_latency)),
          readable(room),
          free(room) {}

    /// Returns the words behind its own.
    StateWord const* load(StateWord const* words) {
        FifoCounts const counts = FifoCounts::of(words);
        words += FifoCounts::words;
        std::uint64_t const tokens = counts.tokens - counts.tokens_over;
        readable.load(counts.tokens_over, words, tokens);
        std::uint64_t const writes = room - counts.tokens - counts.room_over;
        free.load(counts.room_over, words + tokens, writes);
        return words + tokens + writes;
    }
    void start() {
        readable.start();
        free.start();
    }

    /// The largest occupancy that shows in what happened since start(), of pairs of a write and a read, one of which
    /// happened since; or `known`, if that is larger.
    std::uint64_t largest_occupancy(std::uint64_t known = 0) const {
        if (known >= capacity)
            return known;
        std::uint64_t const largest =
            free.consumed() > 0 ? largest_behind_writes(std::max<std::uint64_t>(known, 1)) : known;
        return readable.consumed() > 0 ? largest_before_reads(largest) : largest;
    }

    std::uint64_t capacity;
    std::uint64_t room;
    BenchLine::Cycle read_latency;
    BenchLine::Cycle later_than_write;
    BenchLine readable;  ///< from when on tokens can be read
    BenchLine free;      ///< from when on there is room for a write

  private:
    /// Of reads before start().
    std::uint64_t largest_behind_writes(std::uint64_t largest) const {
        std::uint64_t const writes = free.consumed(), known = free.all_count() - free.appended();
        if (known == 0)
            return largest;
        BenchLine::Cycle const* const freed = free.all();
        BenchLine::Cycle const* const written = readable.fresh();  // each readable read_latency later
        BenchLine::Cycle const earlier = read_latency - 1;
        // Neither does a later write find one of those reads behind it: times never fall.
        BenchLine::Cycle const last = freed[known - 1] + earlier;
        for (std::uint64_t w = 0; w < writes && written[w] < last; ++w) {
            BenchLine::Cycle const until = written[w] - earlier;
            // The oldest of the m tokens before this one was read a cycle before freed[w + room - m].
            std::uint64_t m = std::max(largest, w + room + 1 - known);
            for (; m < capacity && freed[w + room - m] > until; largest = m)
                ++m;
            if (largest == capacity)
                break;
        }
        return largest;
    }
    /// Of writes before them, whenever they were.
    std::uint64_t largest_before_reads(std::uint64_t largest) const {
        std::uint64_t const reads = readable.consumed(), known = readable.all_count();
        BenchLine::Cycle const* const readable_from = readable.all();
        BenchLine::Cycle const* const read = free.fresh();  // each a cycle later
        std::uint64_t token = largest;                      // the first that is not written before a read
        for (std::uint64_t r = 0; r < reads && token < known && largest < capacity; ++r, ++token) {
            BenchLine::Cycle const until = read[r] - 1 + read_latency;
            for (; readable_from[token] < until; largest = token - r) {
                ++token;
                if (token - r == capacity || token == known)
                    return token - r;
            }
        }
        return largest;
    }
};

}  // namespace faster::timing
