#pragma once
#include <algorithm>
#include <cstdint>

#include "faster/data/image.hpp"

namespace faster::reference {

/// Base of what turns the edge tokens of one sample into its edge map: one class per accelerator.edge_map.algorithm,
/// with its own of the functions below. Works on two W x W maps of the caller, which it clears: the contour, and the
/// pixels known to be no contour as the object is there. By itself, for flows that make no contour while they draw, it
/// leaves them empty.
class EdgeMapBuilder {
  public:
    EdgeMapBuilder(Image<std::uint8_t>& edge_map, Image<std::uint8_t>& object_map)
        : edge_map_(edge_map), object_map_(object_map) {
        std::fill(edge_map_.pixels().begin(), edge_map_.pixels().end(), std::uint8_t{0});
        std::fill(object_map_.pixels().begin(), object_map_.pixels().end(), std::uint8_t{0});
    }

    /// Every token is announced, also one outside the window.
    void next_token() {}
    /// A token of a covered pixel, row and column those of the window, inside it.
    void object(int /*row*/, int /*col*/) {}
    /// Any other token, likewise.
    void edge(int /*row*/, int /*col*/) {}
    /// After the last token; `flush_last` is the key accelerator.edge_map.flush_last.
    void end(bool /*flush_last*/) {}

  protected:
    Image<std::uint8_t>& edge_map_;
    Image<std::uint8_t>& object_map_;
};

}  // namespace faster::reference
