#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "common/mesh.hpp"

namespace faster::io {

/// A mesh as bytes, from one process to another on the same host.
std::string mesh_bytes(Mesh const& mesh);

/// And back. Nothing if the lengths do not fit, or a face names a vertex that is not there: the bytes may come from a
/// process that has gone wrong.
std::optional<Mesh> mesh_from_bytes(std::string_view bytes);

}  // namespace faster::io
