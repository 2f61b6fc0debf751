#pragma once
#include <algorithm>
#include <cstdint>

#include "faster/data/image.hpp"

namespace faster::reference {

/// Base of what turns the edge tokens of one sample into its edge map: one class per accelerator.edge_map.algorithm.
/// Works on two W x W maps of the caller, which it clears: the contour, and the pixels known to be no contour as the
/// object is there. Each class has
///   next_token()          told of every token first, also of one outside the window
///   object(row, col)      a token of a covered pixel, row and column those of the window, inside it
///   edge(row, col)        any other token, likewise
///   end(flush_last)       after the last one; `flush_last` is the key accelerator.edge_map.flush_last
class EdgeMapBuilder {
  protected:
    EdgeMapBuilder(Image<std::uint8_t>& edge_map, Image<std::uint8_t>& object_map)
        : edge_map_(edge_map), object_map_(object_map) {
        std::fill(edge_map_.pixels().begin(), edge_map_.pixels().end(), std::uint8_t{0});
        std::fill(object_map_.pixels().begin(), object_map_.pixels().end(), std::uint8_t{0});
    }

    Image<std::uint8_t>& edge_map_;
    Image<std::uint8_t>& object_map_;
};

}  // namespace faster::reference
