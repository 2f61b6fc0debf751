#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace faster::io {

/// Where a Wavefront OBJ file has a vertex with a coordinate that is not finite (in single precision). Only for error
/// messages: assimp forgets which vertex of the file a corner came from.
struct ObjVertexPlace {
    std::size_t index = 0;  ///< among the `v` lines, from 0
    std::size_t line = 0;   ///< in the file, from 1
};
std::optional<ObjVertexPlace> first_bad_obj_vertex(std::string_view file);

}  // namespace faster::io
