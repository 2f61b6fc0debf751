#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "dataflow/base/cycles.hpp"
#include "dataflow/base/zeros.hpp"

namespace dataflow::timing {

/// Cycles in order, of which the last ones are kept: those that are known and not consumed, and those consumed just
/// before. A ring.
class CycleRing {
  public:
    using Time = Cycles;
    using Cycle = Cycles;

    /// At most so many are known at a time.
    explicit CycleRing(std::uint64_t most) : cycles_(power_of_two_above(most)), mask_(cycles_.size() - 1) {}

    std::uint64_t known() const { return appended_ - consumed_; }
    std::uint64_t consumed() const { return consumed_; }
    Cycles operator[](std::uint64_t i) const { return cycles_[(consumed_ + i) & mask_]; }
    Cycles& operator[](std::uint64_t i) { return cycles_[(consumed_ + i) & mask_]; }

    void consume(std::uint64_t count) { consumed_ += count; }
    void append(Cycles cycle) {
        cycles_[appended_at_ + (appended_ & mask_)] = cycle;
        ++appended_;
    }

    /// Appends what `next()` gives, again and again. In pieces that lie side by side, so that a compiler can make
    /// vectors of them.
    template <class Next> void append(std::uint64_t count, Next next) {
        for (std::uint64_t done = 0; done < count;) {
            std::uint64_t const at = appended_ & mask_;
            std::uint64_t const now = std::min(count - done, mask_ + 1 - at);
            Cycles* const to = cycles_.data() + appended_at_ + at;
            for (std::uint64_t i = 0; i < now; ++i)
                to[i] = next();
            appended_ += now;
            done += now;
        }
    }

    /// Many at once: what is to be consumed, and what is to be appended; the line itself changes with consume() and
    /// done().
    class Reader {
      public:
        Reader() = default;
        Reader(Cycles const* cycles, std::uint64_t at, std::uint64_t mask) : cycles_(cycles), at_(at), mask_(mask) {}
        Cycles operator[](std::uint64_t i) const { return cycles_[(at_ + i) & mask_]; }

      private:
        Cycles const* cycles_ = nullptr;
        std::uint64_t at_ = 0, mask_ = 0;
    };
    class Writer {
      public:
        Writer() = default;
        Writer(Cycles* cycles, std::uint64_t at, std::uint64_t mask) : cycles_(cycles), at_(at), mask_(mask) {}
        Cycles& operator[](std::uint64_t i) const { return cycles_[(at_ + i) & mask_]; }

      private:
        Cycles* cycles_ = nullptr;
        std::uint64_t at_ = 0, mask_ = 0;
    };
    Reader reader() const { return {cycles_.data(), consumed_, mask_}; }
    Writer writer(std::uint64_t /*count*/) { return {cycles_.data() + appended_at_, appended_, mask_}; }
    void done(std::uint64_t count) { appended_ += count; }

    /// From now on, `count` zeros are known, however many are consumed, and what is appended is never looked at.
    void be_endless(std::uint64_t count) {
        cycles_ = Zeros<Cycles>(2 * (mask_ + 1));
        appended_at_ = mask_ + 1;
        appended_ = consumed_ + count;
    }
    /// Of the last, known or consumed.
    std::uint64_t kept() const { return std::min(appended_, mask_ + 1); }
    /// Makes room for as many again.
    void grow() {
        CycleRing larger(2 * mask_ + 1);
        larger.consumed_ = consumed_;
        larger.appended_ = appended_ - kept();
        for (std::uint64_t i = appended_ - kept(); i < appended_; ++i)
            larger.append(cycles_[appended_at_ + (i & mask_)]);
        *this = std::move(larger);
    }
    /// From the beginning on, so many zeros are known.
    void begin_with(std::uint64_t known) { appended_ = consumed_ + known; }

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
        appended_ = consumed_ + over + count;
        load(over, when, count, base, from);
    }
    template <class Word>
    void load_front(std::uint64_t over, Cycles when, std::uint64_t count, Cycles base, Word const* from) {
        consumed_ = appended_ - over - count;
        load(over, when, count, base, from);
    }
    /// As if `count` more had gone through in `cycles`, and nothing else had changed.
    void shift(std::uint64_t count, Cycles cycles) {
        std::vector<Cycles> ahead;
        for (std::uint64_t i = 0; i < known(); ++i)
            ahead.push_back((*this)[i] + cycles);
        consumed_ += count;
        appended_ += count;
        for (std::uint64_t i = 0; i < ahead.size(); ++i)
            (*this)[i] = ahead[i];
    }

  private:
    template <class Word>
    void load(std::uint64_t over, Cycles when, std::uint64_t count, Cycles base, Word const* from) {
        for (std::uint64_t i = 0; i < over; ++i)
            (*this)[i] = when;
        for (std::uint64_t i = 0; i < count; ++i)
            (*this)[over + i] = base + static_cast<Cycles>(std::int64_t{from[i]});
    }
    static std::uint64_t power_of_two_above(std::uint64_t value) {
        std::uint64_t power = 1;
        while (power <= value)
            power *= 2;
        return power;
    }

    Zeros<Cycles> cycles_;
    std::uint64_t mask_;
    std::uint64_t appended_at_ = 0;  ///< in cycles_: where appending begins
    std::uint64_t consumed_ = 0;
    std::uint64_t appended_ = 0;
};

}  // namespace dataflow::timing
