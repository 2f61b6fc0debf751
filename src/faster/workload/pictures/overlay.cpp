#include "faster/workload/pictures/overlay.hpp"

#include "faster/workload/pictures/colour.hpp"

namespace faster::pictures {

namespace {

Colour overlay_colour(bool is_edge, bool is_object, bool is_observed) {
    if (is_edge)
        return is_observed ? palette::edge_on_observed_edge : palette::edge_map;
    if (is_object)
        return palette::object_map;
    return is_observed ? palette::observed_edges : palette::paper;
}

/// Centres may lie anywhere in 32 bits, so the sums need more.
bool is_observed_edge(Stimulus const& stimulus, std::int64_t row, std::int64_t col) {
    return row >= 0 && row < stimulus.height && col >= 0 && col < stimulus.width &&
           stimulus.observed_edges.at(static_cast<int>(row), static_cast<int>(col)) != 0;
}

}  // namespace

Image<std::uint8_t> observed_edges_in_window(Stimulus const& stimulus, SampleInput const& sample) {
    int const side = stimulus.window;
    Image<std::uint8_t> window(side, side);
    std::int64_t const top = stimulus.window_offset(sample.centre_row);
    std::int64_t const left = stimulus.window_offset(sample.centre_col);
    for (int row = 0; row < side; ++row)
        for (int col = 0; col < side; ++col)
            window.at(row, col) = is_observed_edge(stimulus, top + row, left + col) ? 1 : 0;
    return window;
}

Image<Colour> overlay(Image<std::uint8_t> const& edge_map, Image<std::uint8_t> const& object_map,
                      Image<std::uint8_t> const& observed_edges) {
    Image<Colour> picture(edge_map.height(), edge_map.width());
    for (int row = 0; row < picture.height(); ++row)
        for (int col = 0; col < picture.width(); ++col)
            picture.at(row, col) = overlay_colour(edge_map.at(row, col) != 0, object_map.at(row, col) != 0,
                                                  observed_edges.at(row, col) != 0);
    return picture;
}

}  // namespace faster::pictures
