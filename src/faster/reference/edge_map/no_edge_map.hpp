#pragma once
#include "faster/reference/edge_map/edge_map_builder.hpp"

namespace faster::reference {

/// For flows that make no contour while they draw: the maps stay empty.
class NoEdgeMap : public EdgeMapBuilder {
  public:
    NoEdgeMap(Image<std::uint8_t>& edge_map, Image<std::uint8_t>& object_map) : EdgeMapBuilder(edge_map, object_map) {}

    void next_token() {}
    void object(int /*row*/, int /*col*/) {}
    void edge(int /*row*/, int /*col*/) {}
    void end(bool /*flush_last*/) {}
};

}  // namespace faster::reference
