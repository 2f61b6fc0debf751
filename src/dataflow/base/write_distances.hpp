#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace dataflow {

/// How many iterations of a loop lie between one that writes a word of a memory and a later one that reads or writes
/// it, within one entry of the loop: what `dependence inter false` promises to be enough. Every iteration counts once
/// for every word, with the last iteration before it that wrote the word.
class WriteDistances {
  public:
    /// `counted`: distances below this are counted one by one.
    WriteDistances(std::uint64_t words, std::uint64_t counted) : written_(words), met_(words), counts_(counted) {}

    /// The loop is entered: nothing has been written.
    void enter() {
        if (now_ > most_iterations)
            forget();
        entry_ = now_;
    }
    void next_iteration() {
        ++now_;
        nearest_before_ = std::exchange(nearest_, 0);
    }
    void read(std::size_t word) {
        if (std::exchange(met_[word], now_) != now_)
            meet(written_[word]);
    }
    void write(std::size_t word) {
        read(word);
        written_[word] = now_;
    }

    /// Of the iteration at hand, or the one before it: the smallest of its distances; 0: it met nothing.
    std::uint64_t nearest() const { return nearest_; }
    std::uint64_t nearest_before() const { return nearest_before_; }

    /// 0: no iteration met a word that one before it had written.
    std::uint64_t smallest() const { return smallest_; }
    /// By distance, from 0 on, which does not happen.
    std::vector<std::uint64_t> const& counts() const { return counts_; }

  private:
    using Iteration = std::uint32_t;
    static constexpr Iteration most_iterations = Iteration{1} << 31;

    void meet(Iteration written) {
        if (written <= entry_)
            return;
        std::uint64_t const distance = now_ - written;
        if (nearest_ == 0 || distance < nearest_)
            nearest_ = distance;
        if (smallest_ == 0 || distance < smallest_)
            smallest_ = distance;
        if (distance < counts_.size())
            ++counts_[distance];
    }
    void forget() {
        std::fill(written_.begin(), written_.end(), Iteration{0});
        std::fill(met_.begin(), met_.end(), Iteration{0});
        now_ = 0;
    }

    std::vector<Iteration> written_;  ///< by word: the last iteration that did
    std::vector<Iteration> met_;      ///< by word: the last iteration that read or wrote it
    std::vector<std::uint64_t> counts_;
    Iteration now_ = 0;  ///< over all entries
    Iteration entry_ = 0;
    std::uint64_t smallest_ = 0;
    std::uint64_t nearest_ = 0;
    std::uint64_t nearest_before_ = 0;
};

/// Counts nothing, and costs nothing.
struct NoWriteDistances {
    void next_iteration() {}
    void read(std::size_t /*word*/) {}
    void write(std::size_t /*word*/) {}
};

}  // namespace dataflow
