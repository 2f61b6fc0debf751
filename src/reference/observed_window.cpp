#include "reference/observed_window.hpp"

#include <algorithm>

namespace faster::reference {
namespace {

// The indices of a window of `size` at `offset` that lie in an image of `image_size`, as [first, last).
struct Overlap {
    Overlap(std::int64_t offset, int size, int image_size)
        : first(static_cast<int>(std::clamp<std::int64_t>(-offset, 0, size))),
          last(static_cast<int>(std::clamp<std::int64_t>(image_size - offset, first, size))) {}
    int first;
    int last;
};

template <class Pixel> void copy_window(Image<Pixel> const& image, WindowOffset offset, Image<Pixel>& window) {
    std::fill(window.pixels().begin(), window.pixels().end(), Pixel{0});
    Overlap const rows(offset.row, window.height(), image.height());
    Overlap const cols(offset.col, window.width(), image.width());
    if (cols.first == cols.last) {
        return;
    }
    for (int row = rows.first; row < rows.last; ++row) {
        Pixel const* source = &image.at(static_cast<int>(offset.row + row), static_cast<int>(offset.col + cols.first));
        std::copy_n(source, cols.last - cols.first, &window.at(row, cols.first));
    }
}

}  // namespace

WindowOffset window_offset(SampleInput const& sample, int window) {
    return {std::int64_t{sample.centre_row} - window / 2, std::int64_t{sample.centre_col} - window / 2};
}

void read_window(Stimulus const& stimulus, WindowOffset offset, ObservedWindow& observed) {
    copy_window(stimulus.observed_depth, offset, observed.depth);
    copy_window(stimulus.observed_edges, offset, observed.edges);
}

}  // namespace faster::reference
