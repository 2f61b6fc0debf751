#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

namespace faster::datapath {

/// A W x W map of single bits, row by row; each row starts at a word.
class Bitmap {
  public:
    explicit Bitmap(int side)
        : side_(side),
          words_per_row_((side + 63) / 64),
          words_(static_cast<std::size_t>(side) * static_cast<std::size_t>(words_per_row_)) {}

    int side() const { return side_; }
    void clear() { std::fill(words_.begin(), words_.end(), 0); }
    bool test(int row, int col) const { return (word(row, col) >> (col & 63) & 1U) != 0; }
    void set(int row, int col) { word(row, col) |= std::uint64_t{1} << (col & 63); }
    void reset(int row, int col) { word(row, col) &= ~(std::uint64_t{1} << (col & 63)); }

    /// Visits the words of a row that hold columns [from, to], with the mask of those columns.
    template <class Visit> void for_each_word(int row, int from, int to, Visit visit) {
        std::uint64_t* const words = words_.data() + index(row, 0);
        for (int w = from >> 6; w <= to >> 6; ++w) {
            std::uint64_t const above = w == from >> 6 ? ~std::uint64_t{0} << (from & 63) : ~std::uint64_t{0};
            std::uint64_t const below = w == to >> 6 ? ~std::uint64_t{0} >> (63 - (to & 63)) : ~std::uint64_t{0};
            visit(words[w], above & below, static_cast<std::size_t>(&words[w] - words_.data()));
        }
    }
    std::uint64_t word(std::size_t at) const { return words_[at]; }

    /// Writes bits [first, first + count) in row-major order, one byte each, 0 or 1.
    void unpack(std::size_t first, std::size_t count, std::uint8_t* bytes) const;

  private:
    std::size_t index(int row, int col) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(words_per_row_) +
               static_cast<std::size_t>(col >> 6);
    }
    std::uint64_t& word(int row, int col) { return words_[index(row, col)]; }
    std::uint64_t word(int row, int col) const { return words_[index(row, col)]; }

    int side_;
    int words_per_row_;
    std::vector<std::uint64_t> words_;
};

}  // namespace faster::datapath
