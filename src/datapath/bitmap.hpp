#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace faster::datapath {

/// A W x W map of single bits, row by row; each row starts at a word. A row above and one below guard it.
class Bitmap {
  public:
    explicit Bitmap(int side)
        : side_(side),
          words_per_row_((side + 63) / 64),
          words_(static_cast<std::size_t>(side + 2) * static_cast<std::size_t>(words_per_row_)) {}

    int side() const { return side_; }
    void clear() { std::fill(words_.begin(), words_.end(), 0); }
    bool test(int row, int col) const { return (word(row, col) >> (col & 63) & 1U) != 0; }
    void set(int row, int col) { word(row, col) |= std::uint64_t{1} << (col & 63); }
    void reset(int row, int col) { word(row, col) &= ~(std::uint64_t{1} << (col & 63)); }

    /// The word that holds a pixel; rows -1 and side() are there to be written, and never read out.
    std::uint64_t* word_at(int row, int col) { return words_.data() + index(row, col); }
    std::ptrdiff_t words_per_row() const { return words_per_row_; }

    /// Writes bits [first, first + count) in row-major order, one byte each, 0 or 1.
    void unpack(std::size_t first, std::size_t count, std::uint8_t* bytes) const;

  private:
    std::size_t index(int row, int col) const {
        return static_cast<std::size_t>(row + 1) * static_cast<std::size_t>(words_per_row_) +
               static_cast<std::size_t>(col >> 6);
    }
    std::uint64_t& word(int row, int col) { return words_[index(row, col)]; }
    std::uint64_t word(int row, int col) const { return words_[index(row, col)]; }

    int side_;
    int words_per_row_;
    std::vector<std::uint64_t> words_;
};

}  // namespace faster::datapath
