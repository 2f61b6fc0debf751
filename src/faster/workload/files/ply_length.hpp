#pragma once
#include <string_view>

namespace faster::files {

/// True if a PLY file ends before the last element its header announces, or before the header does. assimp does not
/// notice: it repeats what it read last, and a repeated triangle is counted twice, or searches for the header's end for
/// ever. False for a header that makes no sense otherwise, which assimp rejects.
bool is_truncated_ply(std::string_view file);

}  // namespace faster::files
