#include "faster/reference/inlier_sweep.hpp"

#include <algorithm>
#include <cstdlib>

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

// The lengths of thesis A.3 as depth codes.
struct Limits {
    explicit Limits(int fraction_bits)
        : drawn(std::int64_t{2} << fraction_bits), valid(std::int64_t{3} << fraction_bits), fraction(fraction_bits) {}

    // 0.008 m in ufixed<8,0> is 2/256, that is difference / 2^fraction <= 1 / 2^7; exact also below 7 bits.
    bool near(std::int64_t difference) const { return (std::abs(difference) << 7) <= (std::int64_t{1} << fraction); }

    std::int64_t drawn;  // below: something is drawn here
    std::int64_t valid;  // up to here: an observation counts
    int fraction;
};

// An edge pixel lies just outside the object, so its depth is that of a neighbour: below, above, right, left.
std::int64_t neighbour_depth(Image<std::uint16_t> const& depth, int row, int col, Limits const& limits) {
    std::int64_t const neighbours[] = {depth.at(row + 1, col), depth.at(row - 1, col), depth.at(row, col + 1),
                                       depth.at(row, col - 1)};
    for (std::int64_t const neighbour : neighbours) {
        if (neighbour < limits.drawn) {
            return neighbour;
        }
    }
    return 0;
}

}  // namespace

void read_window(Stimulus const& stimulus, WindowOffset offset, ObservedWindow& observed) {
    copy_window(stimulus.observed_depth, offset, observed.depth);
    copy_window(stimulus.observed_edges, offset, observed.edges);
}

void sweep(SampleMaps const& maps, ObservedWindow const& observed, int depth_fraction_bits, EdgeDepth edge_depth,
           SampleCounters& counters) {
    Limits const limits(depth_fraction_bits);
    for (int row = 1; row < maps.edge_map.height() - 1; ++row) {
        for (int col = 1; col < maps.edge_map.width() - 1; ++col) {
            bool const edge = maps.edge_map.at(row, col) != 0;
            std::int64_t const seen = observed.depth.at(row, col);
            std::int64_t const drawn = edge && edge_depth == EdgeDepth::of_neighbour
                                           ? neighbour_depth(maps.depth_buffer, row, col, limits)
                                           : maps.depth_buffer.at(row, col);
            if (edge) {
                ++counters.valid_edge;
            }
            if (drawn < limits.drawn && limits.near(drawn - seen)) {
                ++counters.inlier;
                if (edge && observed.edges.at(row, col) != 0) {
                    ++counters.edge_inlier;
                }
            }
            if (seen <= limits.valid) {
                ++counters.valid_depth;
            }
        }
    }
}

void count_hidden(Image<std::uint16_t> const& depth_buffer, Image<std::uint16_t> const& observed_depth,
                  int depth_fraction_bits, SampleCounters& counters) {
    Limits const limits(depth_fraction_bits);
    int const side = depth_buffer.height();
    int top = side;
    int left = side;
    int bottom = 0;
    int right = 0;
    for (int row = 1; row < side - 1; ++row) {
        for (int col = 1; col < side - 1; ++col) {
            std::int64_t const drawn = depth_buffer.at(row, col);
            std::int64_t const seen = observed_depth.at(row, col);
            if (drawn >= limits.drawn) {
                continue;
            }
            bool const is_measured = seen > 0;
            if (is_measured && seen < drawn && !limits.near(drawn - seen)) {
                ++counters.hidden;
            } else {
                top = std::min(top, row);
                left = std::min(left, col);
                bottom = std::max(bottom, row);
                right = std::max(right, col);
            }
        }
    }
    if (bottom > 0) {
        counters.visible_top = static_cast<std::uint64_t>(top);
        counters.visible_left = static_cast<std::uint64_t>(left);
        counters.visible_bottom = static_cast<std::uint64_t>(bottom);
        counters.visible_right = static_cast<std::uint64_t>(right);
    }
}

}  // namespace faster::reference
