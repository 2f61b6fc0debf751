#pragma once
#include <string_view>

namespace faster::io {

/// True if a PLY file ends before the last element its header announces. assimp does not notice: it repeats what it
/// read last, and a repeated triangle is counted twice. False for a header that makes no sense, which assimp rejects.
bool is_truncated_ply(std::string_view file);

}  // namespace faster::io
