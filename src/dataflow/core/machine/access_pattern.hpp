#pragma once
#include <cstddef>
#include <vector>

namespace dataflow {

/// A word of a memory that holds the window, seen from the pixel that a loop iteration works on.
struct PixelOffset {
    int row = 0;  ///< downwards
    int col = 0;  ///< to the right
};
inline bool operator==(PixelOffset a, PixelOffset b) { return a.row == b.row && a.col == b.col; }
inline bool operator<(PixelOffset a, PixelOffset b) { return a.row != b.row ? a.row < b.row : a.col < b.col; }

/// The words of one memory that an iteration of a loop touches in its worst branch, each once: a word read by two
/// parts of the iteration is read once. A word both read and written is two accesses.
struct AccessPattern {
    std::vector<PixelOffset> reads;
    std::vector<PixelOffset> writes;

    std::size_t accesses() const { return reads.size() + writes.size(); }
};

/// What an iteration touches that works on `lanes` pixels of a row, each as `one_pixel` says; `lanes` >= 1.
AccessPattern widened(AccessPattern const& one_pixel, int lanes);

}  // namespace dataflow
