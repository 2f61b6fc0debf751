#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kernel/base/cycles.hpp"

namespace faster::timing {

/// Cycles in order, of which the last ones are kept: those that are known and not consumed, and others before them.
/// They lie in a row, and move back to its begin when they come to its end.
class CycleLine {
  public:
    using Time = Cycles;
    using Cycle = Cycles;
    using Reader = Cycles const*;
    using Writer = Cycles*;

    /// Of those appended last, so many are kept, or as many as can be known at a time, if that is less.
    static constexpr std::uint64_t longest_past = 1024;

    /// At most so many are known at a time.
    explicit CycleLine(std::uint64_t most)
        : most_(most),
          length_(2 * most + between_moves),
          gone_(0 - most),
          front_(most),
          end_(most),
          cycles_(length_, 0) {}

    std::uint64_t known() const { return end_ - front_; }
    /// From the beginning on.
    std::uint64_t consumed() const { return gone_ + front_; }
    /// The i-th from the front on; negative: before it.
    Cycles operator[](std::uint64_t i) const { return cycles_[front_ + i]; }
    Cycles& operator[](std::uint64_t i) { return cycles_[front_ + i]; }

    void consume(std::uint64_t count) { front_ += count; }
    void append(Cycles cycle) {
        *writer(1) = cycle;
        ++end_;
    }

    /// Many at once: what is to be consumed, and what is to be appended; the line itself changes with consume() and
    /// done().
    Reader reader() const { return cycles_.data() + front_; }
    Writer writer(std::uint64_t count) {
        if (end_ + count > length_)
            move_back();
        return cycles_.data() + appended_at_ + end_;
    }
    void done(std::uint64_t count) { end_ += count; }

    /// From the beginning on, so many zeros are known.
    void begin_with(std::uint64_t known) { end_ = front_ + known; }
    /// From now on, `count` zeros are known, however many are consumed: what is appended is put elsewhere.
    void be_endless(std::uint64_t count) {
        cycles_.assign(2 * length_, 0);
        appended_at_ = length_;
        end_ = front_ + count;
    }
    /// Makes room for as many again.
    void grow() {
        CycleLine larger(2 * most_ + 1);
        larger.gone_ += consumed();
        for (std::uint64_t i = 0; i < known(); ++i)
            larger.append((*this)[i]);
        *this = larger;
    }
    /// As if `count` more had gone through in `cycles`, and nothing else had changed.
    void shift(std::uint64_t count, Cycles cycles) {
        for (std::uint64_t i = 0; i < known(); ++i)
            (*this)[i] += cycles;
        gone_ += count;
    }

    /// How many, from the front on, are not after a cycle. They never fall.
    std::uint64_t count_until(std::int64_t cycle) const {
        std::uint64_t count = known();
        while (count > 0 && static_cast<std::int64_t>((*this)[count - 1]) > cycle)
            --count;
        return count;
    }
    /// Puts `count` down, relative to a base.
    template <class Word> void copy(std::uint64_t first, std::uint64_t count, std::int64_t base, Word* to) const {
        for (std::uint64_t i = 0; i < count; ++i)
            to[i] = static_cast<Word>(static_cast<std::int64_t>((*this)[first + i]) - base);
    }
    /// Takes them up, behind some that are over: by changing what was appended, or what was consumed.
    template <class Word>
    void load_end(std::uint64_t over, Cycles when, std::uint64_t count, Cycles base, Word const* from) {
        if (front_ + over + count > length_)
            move_back();
        end_ = front_ + over + count;
        load(over, when, count, base, from);
    }
    template <class Word>
    void load_front(std::uint64_t over, Cycles when, std::uint64_t count, Cycles base, Word const* from) {
        if (end_ < over + count)
            move_forward();
        front_ = end_ - over - count;
        load(over, when, count, base, from);
    }

  private:
    static constexpr std::uint64_t between_moves = 64;

    template <class Word>
    void load(std::uint64_t over, Cycles when, std::uint64_t count, Cycles base, Word const* from) {
        for (std::uint64_t i = 0; i < over; ++i)
            (*this)[i] = when;
        for (std::uint64_t i = 0; i < count; ++i)
            (*this)[over + i] = base + static_cast<Cycles>(std::int64_t{from[i]});
    }
    [[gnu::noinline]] void move_back() {
        std::uint64_t const by = end_ - std::max(known(), std::min(most_, longest_past));
        Cycles* const appended = cycles_.data() + appended_at_;
        std::copy(appended + by, appended + end_, appended);
        gone_ += by;
        front_ -= by;
        end_ -= by;
    }

    /// So that there is room for all that can be known before the end. What is there is lost.
    void move_forward() {
        gone_ -= most_ - end_;
        end_ = most_;
    }

    std::uint64_t most_;
    std::uint64_t length_;
    std::uint64_t appended_at_ = 0;  ///< so far behind their place are those put that are appended
    std::uint64_t gone_;             ///< moved out, from the beginning on
    std::uint64_t front_;
    std::uint64_t end_;
    std::vector<Cycles> cycles_;
};

}  // namespace faster::timing
